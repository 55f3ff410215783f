# The pages link to more than Doxygen has: of such links the text stays.
s:\[([^]]*)\]\((#[^)]*|[^):]*\.(cpp|js|txt|yaml|sh))\):\1:g
# It has a picture's text on one line, and pictures lie beside what it writes.
:join
/^!\[[^]]*$/ {
  N
  s:\n: :
  b join
}
s:\]\((\.\./)*data/pictures/:](:g
