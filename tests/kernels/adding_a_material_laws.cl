// The laws of models (bsdf_laws.h) for the one of docs/adding_a_material.md.

#include "adding_a_material.cl"
#include "test_bsdf.cl"
