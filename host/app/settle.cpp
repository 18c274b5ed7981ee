// What options say together, after each has been read by itself.
#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "app/options.h"
#include "image/write_image.h"
#include "options/render_option_table.h"

namespace pencil {

namespace {

/// In the order of preference.
constexpr MethodName every_method[] = {MethodName::surface, MethodName::line, MethodName::hybrid};

/// Layers that names of PNGs ask for.
void add_named_layers(const std::vector<std::filesystem::path>& outputs, std::vector<std::string>& layers) {
    for (const std::filesystem::path& output : outputs) {
        const std::string name = output.has_extension() ? layer_of_name(output) : "";
        if (!name.empty() && !has_group(layers, name)) layers.push_back(name);
    }
}

bool is_given(const std::string& flag, const std::vector<Option>& table, const Given& given) {
    return std::any_of(
        table.begin(), table.end(), [&](const Option& row) { return row.flag == flag && given(row); });
}

/// Whether a method knows all options that are given.
bool fits(const std::string& method, const std::vector<Option>& table, const Given& given) {
    return std::all_of(
        table.begin(), table.end(), [&](const Option& row) { return !given(row) || serves(row, method); });
}

/// std::invalid_argument if two options are given that no method knows both.
void check_one_method(const std::vector<Option>& table, const Given& given) {
    for (auto a = table.begin(); a != table.end(); ++a)
        for (auto b = a; b != table.end(); ++b) {
            if (!given(*a) || !given(*b)) continue;
            const auto both = [&](MethodName method) { return serves(*a, to_string(method)) && serves(*b, to_string(method)); };
            if (std::none_of(std::begin(every_method), std::end(every_method), both))
                throw std::invalid_argument(a->flag + " excludes " + b->flag + ": one is an option of --method " + a->methods +
                                            ", the other of " + b->methods);
        }
}

}  // namespace

void settle(RenderCommand& command, const std::vector<Option>& table, const Given& given) {
    const bool named = is_given("--method", table, given);
    if (!named) check_one_method(table, given);
    for (const MethodName method : every_method)
        if (!named && fits(to_string(method), table, given)) {
            command.options.method = method;
            break;
        }
    for (const char* flag : {"--pencils", "--map", "--map-kind", "--bounces", "--decay", "--least-pencils", "--iterate", "--placement",
                             "--tolerance", "--radiance-map", "--density-map"})
        if (!command.field.empty() && is_given(flag, table, given))
            throw std::invalid_argument(std::string(flag) + ": is decided by the --field");
    if (command.field.empty() && is_given("--field-pencils", table, given))
        throw std::invalid_argument("--field-pencils: is an option of --field");
    add_named_layers(command.outputs, command.options.aovs);
    const std::string method = to_string(command.options.method);
    for (const Option& row : table)
        if (given(row) && !serves(row, method)) throw std::invalid_argument(row.flag + ": is not an option of --method " + method);
}

void settle(ReferenceCommand& command, const std::vector<Option>& table, const Given& given) {
    add_named_layers(command.outputs, command.aovs);
    const auto has = [&](const std::string& flag) { return is_given(flag, table, given); };
    if (has("--spp") && has("--time")) throw std::invalid_argument("--time excludes --spp");
}

void settle(MeasureCommand& command, const std::vector<Option>& table, const Given& given) {
    const auto has = [&](const std::string& flag) { return is_given(flag, table, given); };
    const bool target = has("--target-error");
    if (target && has("--time")) throw std::invalid_argument("--time excludes --target-error");
    if (target && command.method == MeasureMethod::reference)
        throw std::invalid_argument("--target-error: is not an option of --method reference");
    if (has("--device") && command.method == MeasureMethod::reference)
        throw std::invalid_argument("--device: is not an option of --method reference");
    command.options.seconds = target ? 0 : command.seconds;
}

void settle(StressCommand& command, const std::vector<Option>&, const Given&) {
    if (command.json && command.markdown) throw std::invalid_argument("--json excludes --markdown");
    if (command.all && !command.cases.empty()) throw std::invalid_argument("--all excludes --case");
}

}  // namespace pencil
