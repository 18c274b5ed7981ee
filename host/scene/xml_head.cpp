#include "scene/xml_head.h"

#include "scene/text.h"

namespace pencil {
namespace {

std::string_view without_mark(std::string_view head) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return trimmed(head.substr(0, mark.size()) == mark ? head.substr(mark.size()) : head);
}

}  // namespace

bool is_xml(std::string_view head) {
    const std::string_view text = without_mark(head);
    return !text.empty() && text[0] == '<';
}

std::string_view xml_root(std::string_view head) {
    for (std::string_view text = without_mark(head); text.size() > 1 && text[0] == '<';) {
        if (text[1] != '?' && text[1] != '!') return text.substr(1, text.find_first_of(" \t\r\n/>") - 1);
        const std::string_view end = text.substr(0, 4) == "<!--" ? "-->" : ">";
        const std::size_t at = text.find(end);
        if (at == std::string_view::npos) break;
        text = trimmed(text.substr(at + end.size()));
    }
    return {};
}

}  // namespace pencil
