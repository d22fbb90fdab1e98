#pragma once
/// Headers that nearly all tests include, for the compiler to parse once. Tests still include what they use.

#include <tbb/parallel_for.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"
