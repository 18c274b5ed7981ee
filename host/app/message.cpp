// Byte by byte: the text need not be valid UTF-8.
#include "app/message.h"

#include <cstdio>

namespace pencil {
namespace {

std::string escape_byte(unsigned char byte) {
    if (byte == '\n' || byte == '\t') return byte == '\n' ? "\\n" : "\\t";
    char text[8];
    std::snprintf(text, sizeof(text), "\\x%02x", byte);
    return text;
}

}  // namespace

std::string printable(const std::string& text, LineBreaks breaks) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
        const bool kept_break = breaks == LineBreaks::keep && (byte == '\n' || byte == '\t');
        if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {  // U+0080 to U+009F: some terminals obey them
            shown += escape_byte(byte) + escape_byte(next);
            ++i;
        } else if ((byte < 0x20 && !kept_break) || byte == 0x7f) {
            shown += escape_byte(byte);
        } else {
            shown += text[i];
        }
    }
    return shown;
}

void print_error(const std::string& text, LineBreaks breaks) {
    std::fprintf(stderr, "pencil: error: %s\n", printable(text, breaks).c_str());
}

void print_warning(const std::string& text) { std::fprintf(stderr, "pencil: warning: %s\n", printable(text).c_str()); }

}  // namespace pencil
