// SPDX-License-Identifier: GPL-3.0-or-later

#include "package.h"

const char* name_of_other()
{
  return "OK";
}
