# The pages link to more than Doxygen has: of such links the text stays.
s:\[([^]]*)\]\((#[^)]*|[^):]*\.(cpp|h|js|mjs|txt|yaml|sh))\):\1:g
# To a page it goes, but not to a place in it.
s:(\]\([^):#]*\.md)#[^)]*\):\1):g
# It has a picture's text on one line, and pictures lie beside what it writes.
:join
/^!\[[^]]*$/ {
  N
  s:\n: :
  b join
}
s:\]\((\.\./)*data/pictures/:](:g
