// Light paths that check images. Kernels that are built together, since a program costs more than a kernel.

#include "trace_checks.cl"
