#include "scene/mitsuba/xml_parameters.h"

#include <utility>

namespace pencil {

XmlParameters::XmlParameters(std::map<std::string, std::string> defines) : values_(std::move(defines)) {
    for (const auto& define : values_) used_[define.first] = false;
}

/// The longest name that fits after a $ is taken, so that $res does not eat half of $resx.
XmlParameters::Substitution XmlParameters::substituted(const std::string& text) {
    Substitution result;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] != '$') {
            result.text += text[i++];
            continue;
        }
        const std::pair<const std::string, std::string>* best = nullptr;
        for (const auto& entry : values_)
            if (text.compare(i + 1, entry.first.size(), entry.first) == 0 && (!best || entry.first.size() > best->first.size()))
                best = &entry;
        if (!best || best->first.empty()) {
            const std::size_t end = std::min(text.find_first_of(" ,/$", i + 1), text.size());
            result.undefined.push_back(text.substr(i + 1, end - i - 1));
            result.text += text.substr(i, end - i);
            i = end;
            continue;
        }
        used_[best->first] = true;
        result.text += best->second;
        result.too_long = result.text.size() > max_value_bytes;
        if (result.too_long) return result;
        i += 1 + best->first.size();
    }
    return result;
}

std::vector<std::string> XmlParameters::unused() const {
    std::vector<std::string> names;
    for (const auto& [name, used] : used_)
        if (!used) names.push_back(name);
    return names;
}

}  // namespace pencil
