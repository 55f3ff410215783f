#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/config/camera/camera_entries.h"

struct _xmlDoc;
struct _xmlNode;

namespace lineservo::apps {

/// One element of an XmlReader, which it must not outlive.
class XmlElement {
 public:
  explicit XmlElement(_xmlNode* node) : node_(node) {}

  std::string name() const;
  int line() const;
  /// Its whole text, split at white space.
  std::vector<std::string> words() const;
  std::vector<XmlElement> children() const;
  /// The first child of that name.
  std::optional<XmlElement> child(const std::string& name) const;

 private:
  _xmlNode* node_;
};

/// An XML file without a document type, and so without entities of its own.
class XmlReader {
 public:
  /// Throws InputError, with file and line, when the text is not such XML.
  XmlReader(std::filesystem::path file, const std::string& text);

  XmlElement root() const;
  const std::filesystem::path& file() const { return file_; }
  /// Throws InputError: "FILE:LINE: message".
  [[noreturn]] void fail(const XmlElement& at, const std::string& message) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<_xmlDoc, void (*)(_xmlDoc*)> document_;
};

/// The children of an element: the words of its text, or of its `data` for a matrix. Throws InputError when a
/// matrix has not rows times cols numbers.
CameraEntries entries_of(const XmlReader& xml, const XmlElement& element);

}  // namespace lineservo::apps
