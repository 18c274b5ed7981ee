#include "app/option_report.h"

#include <nlohmann/json.hpp>
#include <type_traits>

namespace pencil {

namespace {

using Json = nlohmann::ordered_json;

Json value_json(const OptionValue& value) {
    return std::visit(
        [](const auto& v) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::monostate>)
                return {};
            else
                return v;
        },
        value);
}

struct AddToHeader {
    Metadata& metadata;
    std::string name;
    void operator()(std::monostate) const {}
    void operator()(std::int64_t v) const { metadata[name] = static_cast<int>(v); }
    void operator()(std::uint64_t v) const { metadata[name] = std::to_string(v); }  // no header type holds 64 bits
    void operator()(double v) const { metadata[name] = v; }
    void operator()(const std::string& v) const { metadata[name] = v; }
    void operator()(const std::vector<std::string>& v) const { metadata[name] = join(v); }
};

}  // namespace

Json options_json(const std::vector<Option>& table) {
    Json json = Json::object();
    for (const Option& row : table)
        if (row.show) json[option_key(row)] = value_json(row.show());
    return json;
}

void add_options(Metadata& metadata, const std::vector<Option>& table) {
    for (const Option& row : table)
        if (row.show) std::visit(AddToHeader{metadata, "pencil:" + header_name(row)}, row.show());
}

}  // namespace pencil
