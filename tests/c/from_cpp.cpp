/* SPDX-License-Identifier: GPL-3.0-or-later */
// adfric.h from C++: a case and results that close themselves, and errors as exceptions.

#include <cmath>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "adfric.h"

namespace {

void check(int status)
{
   if (status != ADFRIC_OK) throw std::runtime_error(adfric_message());
}

class Case {
public:
   explicit Case(const char *model) { check(adfric_open(model, &handle)); }
   ~Case() { adfric_close_case(handle); }
   Case(const Case &) = delete;
   Case &operator=(const Case &) = delete;
   void set(const char *name, double value) { check(adfric_set_real(handle, name, value)); }
   void sweep(const char *name, const std::vector<double> &values)
   {
      check(adfric_sweep(handle, name, static_cast<int64_t>(values.size()), values.data()));
   }
   std::vector<double> solve(const char *name)
   {
      adfric_results found = 0;
      adfric_array array;
      check(adfric_solve(handle, 1, nullptr, nullptr, &found));
      check(adfric_array_of(found, name, &array));
      std::vector<double> values(array.values, array.values + array.shape[0]);
      check(adfric_close_results(found));
      return values;
   }

private:
   adfric_case handle = 0;
};

// Hertz: a^3 = 3 P R/(4 E*).
bool is_hertz(double radius)
{
   Case ball("sphere");
   const std::vector<double> loads = {1e-6, 8e-6};
   ball.set("radius", radius);
   ball.set("contact_modulus", 1e9);
   ball.set("work_of_adhesion", 0);
   ball.sweep("load", loads);
   const std::vector<double> found = ball.solve("contact_radius");
   bool is_right = found.size() == loads.size();
   for (std::size_t i = 0; is_right && i < found.size(); i++) {
      const double expected = std::cbrt(0.75*loads[i]*radius/1e9);
      is_right = std::abs(found[i] - expected) <= 1e-12*expected;
   }
   return is_right;
}

bool is_refused()
{
   try {
      Case("spere");
   } catch (const std::runtime_error &error) {
      return std::strstr(error.what(), "did you mean 'sphere'?") != nullptr;
   }
   return false;
}

}  // namespace

int main()
{
   bool are_right[4] = {};
   std::vector<std::thread> threads;
   for (int i = 0; i < 4; i++) threads.emplace_back([&are_right, i] { are_right[i] = is_hertz(1e-6*(i + 1)); });
   for (std::thread &thread : threads) thread.join();
   for (bool is_right : are_right)
      if (!is_right) return std::cerr << "not Hertz\n", 1;
   return is_refused() ? 0 : (std::cerr << "not refused\n", 1);
}
