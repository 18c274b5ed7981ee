// SIGINT, SIGTERM and SIGHUP ask the command to stop and save what it has; a second one ends the program at once.
#pragma once

namespace pencil {

/// Installs the handlers. A signal that the parent had us ignore (nohup) stays ignored.
void watch_signals();

/// The signal that arrived, or 0.
int interrupted_by();

}  // namespace pencil
