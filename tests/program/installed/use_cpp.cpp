/* SPDX-License-Identifier: GPL-3.0-or-later */
// Use adfric.h from C++: a name that is wrong is refused with one that may be meant.

#include <adfric.h>
#include <iostream>
#include <string>

int main()
{
   adfric_case tip = 0;
   const std::string version = adfric_version();
   if (adfric_open("spere", &tip) != ADFRIC_BAD_INPUT || tip != 0) return 1;
   if (std::string(adfric_message()).find("did you mean 'sphere'?") == std::string::npos) return 1;
   std::cout << "cpp " << version.substr(0, version.find(' ')) << "\n";
   return 0;
}
