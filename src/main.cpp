// SPDX-License-Identifier: GPL-3.0-or-later

#include <iostream>

int main()
{
  std::cerr << "Usage: idt triangulate|compare|parameterize|table|sample ...\n";
  return 2;
}
