// A finer look at pixels whose light varies much within them. Kernels that are built together, since a program costs more than a kernel.

#include "average_close_ups.cl"
#include "close_ups.cl"
