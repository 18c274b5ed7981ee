// Digits and the letters of units in 5 x 7 pixels, for legends.
#pragma once

#include <functional>
#include <string>

namespace pencil {

constexpr int glyph_width = 5, glyph_height = 7, glyph_step = 6;  // [pixels]

/// Calls dot(x, y) for each dark pixel of `text`, whose upper left corner is (0, 0). Characters that it does not know are blanks.
void draw_text(const std::string& text, const std::function<void(int, int)>& dot);

/// Of the text [pixels].
int text_width(const std::string& text);

}  // namespace pencil
