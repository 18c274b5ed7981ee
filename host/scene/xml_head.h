// What the beginning of a file tells about it as XML.
#pragma once

#include <string_view>

namespace pencil {

/// True if the first character that is no blank and no byte order mark is '<'.
bool is_xml(std::string_view head);

/// Name of the root element, or empty if `head` ends before it or is no XML. Declarations and comments are passed over.
std::string_view xml_root(std::string_view head);

}  // namespace pencil
