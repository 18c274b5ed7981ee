// PoCL compiles a kernel three times over, one for each way to launch it. What is long stands apart, in a function that is compiled once.

#define APART __attribute__((noinline))
