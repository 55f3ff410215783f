#pragma once

/// From now on a connection to a display that breaks, of those that the process has now, calls `broke`;
/// Xlib's own answer is to end the program. Nothing may be asked over that connection afterwards.
void survive_broken_connections(void (*broke)());
