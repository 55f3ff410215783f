#include "apps/config/camera/xml_reader.h"

#include <fmt/format.h>
#include <libxml/parser.h>
#include <libxml/tree.h>

#include <sstream>

#include "apps/config/input_error.h"
#include "apps/config/numbers.h"

namespace lineservo::apps {
namespace {

std::string trimmed(const char* text) {
  std::string line = text == nullptr ? "" : text;
  while (!line.empty() && line.back() == '\n') line.pop_back();
  return line;
}

xmlDoc* parsed(const std::filesystem::path& file, const std::string& text) {
  constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  const std::unique_ptr<xmlParserCtxt, decltype(&xmlFreeParserCtxt)> context(xmlNewParserCtxt(),
                                                                             xmlFreeParserCtxt);
  xmlDoc* document = xmlCtxtReadMemory(context.get(), text.data(), static_cast<int>(text.size()), nullptr,
                                       nullptr, kOptions);
  if (document != nullptr) return document;
  const xmlError* error = xmlCtxtGetLastError(context.get());
  throw InputError(fmt::format("{}:{}: not XML: {}", file.string(), error == nullptr ? 1 : error->line,
                               trimmed(error == nullptr ? "" : error->message)));
}

std::vector<std::string> matrix_words(const XmlReader& xml, const XmlElement& matrix,
                                      const XmlElement& data) {
  const auto side = [&matrix](const char* name) {
    const std::optional<XmlElement> element = matrix.child(name);
    const std::vector<std::string> words = element ? element->words() : std::vector<std::string>{};
    return words.size() == 1 ? parse_number<std::size_t>(words.front(), 0, 1000).value_or(0) : 0;
  };
  std::vector<std::string> words = data.words();
  if (words.size() != side("rows") * side("cols"))
    xml.fail(data, "key 'data' must be as many numbers as 'rows' times 'cols'");
  return words;
}

}  // namespace

std::string XmlElement::name() const {
  return reinterpret_cast<const char*>(node_->name);
}

int XmlElement::line() const {
  return static_cast<int>(xmlGetLineNo(node_));
}

std::vector<std::string> XmlElement::words() const {
  const std::unique_ptr<xmlChar, void (*)(void*)> content(xmlNodeGetContent(node_), xmlFree);
  std::istringstream text(content == nullptr ? "" : reinterpret_cast<const char*>(content.get()));
  return {std::istream_iterator<std::string>(text), {}};
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> list;
  for (xmlNode* node = node_->children; node != nullptr; node = node->next)
    if (node->type == XML_ELEMENT_NODE) list.emplace_back(node);
  return list;
}

std::optional<XmlElement> XmlElement::child(const std::string& name) const {
  for (const XmlElement& element : children())
    if (element.name() == name) return element;
  return std::nullopt;
}

XmlReader::XmlReader(std::filesystem::path file, const std::string& text)
    : file_(std::move(file)), document_(parsed(file_, text), xmlFreeDoc) {
  if (document_->intSubset != nullptr) fail(root(), "a document type (<!DOCTYPE) is not allowed");
}

XmlElement XmlReader::root() const {
  return XmlElement(xmlDocGetRootElement(document_.get()));
}

void XmlReader::fail(const XmlElement& at, const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}", file_.string(), at.line(), message));
}

CameraEntries entries_of(const XmlReader& xml, const XmlElement& element) {
  CameraEntries entries(xml.file(), element.line());
  for (const XmlElement& child : element.children()) {
    const std::optional<XmlElement> data = child.child("data");
    entries.add({child.name(), data ? matrix_words(xml, child, *data) : child.words(), child.line()});
  }
  return entries;
}

}  // namespace lineservo::apps
