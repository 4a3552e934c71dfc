// Prints the table of checksums; `make checksums` commits it.

#include <cstdio>

#include "cases.hpp"

int main() {
  using namespace repeatability;
  for (const Shape& shape : shapes())
    for (const Manner& manner : manners())
      std::printf("%s\n", line(shape, manner, in_memory(shape, manner, 2)).c_str());
}
