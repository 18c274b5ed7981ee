// Files of this folder that are part of the program, put in by cmake/EmbedText.cmake.
#pragma once

namespace pencil {

extern const char* const page_template;    // page.html.mustache
extern const char* const method_template;  // its parts that occur several times
extern const char* const row_template;
extern const char* const plot_template;
extern const char* const page_css;
extern const char* const plot_script;

}  // namespace pencil
