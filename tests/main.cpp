// The main function of every test program, compiled once: Catch2 2 wants it in one translation unit.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
