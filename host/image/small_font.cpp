#include "image/small_font.h"

#include <array>
#include <map>

namespace pencil {

namespace {

/// Rows from the top, # is dark.
using Glyph = std::array<const char*, glyph_height>;

const std::map<char, Glyph>& glyphs() {
    static const std::map<char, Glyph> all{
        {'0', {{" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "}}},
        {'1', {{"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}}},
        {'2', {{" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}}},
        {'3', {{" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}}},
        {'4', {{"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}}},
        {'5', {{"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}}},
        {'6', {{" ### ", "#    ", "#    ", "#### ", "#   #", "#   #", " ### "}}},
        {'7', {{"#####", "    #", "   # ", "   # ", "  #  ", "  #  ", "  #  "}}},
        {'8', {{" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}}},
        {'9', {{" ### ", "#   #", "#   #", " ####", "    #", "    #", " ### "}}},
        {'.', {{"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}}},
        {'-', {{"     ", "     ", "     ", " ### ", "     ", "     ", "     "}}},
        {'+', {{"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}}},
        {'/', {{"    #", "    #", "   # ", "  #  ", " #   ", "#    ", "#    "}}},
        {'c', {{"     ", "     ", " ### ", "#    ", "#    ", "#    ", " ### "}}},
        {'d', {{"    #", "    #", " ####", "#   #", "#   #", "#   #", " ####"}}},
        {'e', {{"     ", "     ", " ### ", "#   #", "#####", "#    ", " ### "}}},
        {'l', {{" ##  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}}},
        {'m', {{"     ", "     ", "## # ", "# # #", "# # #", "# # #", "# # #"}}},
        {'x', {{"     ", "     ", "#   #", " # # ", "  #  ", " # # ", "#   #"}}},
    };
    return all;
}

}  // namespace

void draw_text(const std::string& text, const std::function<void(int, int)>& dot) {
    int left = 0;
    for (const char c : text) {
        const auto glyph = glyphs().find(c);
        for (int y = 0; glyph != glyphs().end() && y < glyph_height; ++y)
            for (int x = 0; x < glyph_width; ++x)
                if (glyph->second[static_cast<std::size_t>(y)][x] == '#') dot(left + x, y);
        left += glyph_step;
    }
}

int text_width(const std::string& text) {
    return text.empty() ? 0 : glyph_step * static_cast<int>(text.size()) - (glyph_step - glyph_width);
}

}  // namespace pencil
