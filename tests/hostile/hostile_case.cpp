#include "hostile/hostile_case.h"

namespace pencil_test {

HostileCase reads(const std::string& name, int code, const std::string& says, const std::string& file,
                  const std::function<std::string()>& content) {
    return {name, code, says, [=](const Folder& folder) { return Arguments{"info", folder.write(file, content())}; }};
}

HostileCase scene_with(const std::string& name, int code, const std::string& says, const std::string& body) {
    return scene_with(name, code, says, body, {});
}

HostileCase scene_with(const std::string& name, int code, const std::string& says, const std::string& body,
                       const std::vector<std::pair<std::string, std::string>>& files) {
    return {name, code, says,
            [=](const Folder& folder) {
                for (const auto& [file, bytes] : files) folder.write(file, bytes);
                return Arguments{"info", folder.write("scene.xml", scene_around(body))};
            }};
}

std::string repeated(const std::string& text, std::size_t count) {
    std::string whole;
    whole.reserve(text.size() * count);
    for (std::size_t i = 0; i < count; ++i) whole += text;
    return whole;
}

std::string scene_around(const std::string& body) {
    return "<scene version=\"3.0.0\"><sensor type=\"perspective\"/><shape type=\"rectangle\"/>\n" + body + "</scene>";
}

}  // namespace pencil_test
