// Messages on stderr. Names in them come from scene files and drivers, so control characters are escaped before a terminal sees them.
#pragma once

#include <string>

namespace pencil {

enum class LineBreaks { keep, escape };

/// `text` with control characters (C0, DEL, C1 in UTF-8) as \n, \t or \xNN. Build logs keep their line breaks and tabs.
std::string printable(const std::string& text, LineBreaks breaks = LineBreaks::escape);

/// "pencil: error: ..." and "pencil: warning: ...".
void print_error(const std::string& text, LineBreaks breaks = LineBreaks::escape);
void print_warning(const std::string& text);

}  // namespace pencil
