// Any text as the value of every option of every command: a value, or std::invalid_argument, which completes the message.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "app/command_line.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<pencil::SubCommand> commands = pencil::sub_commands();  // anew: options that may be repeated keep what they read
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const pencil::SubCommand& command : commands)
        for (const pencil::Option& row : command.table) try {
                row.read(text);
                if (row.show) row.show();
            } catch (const std::invalid_argument&) {
            }
    return 0;
}
