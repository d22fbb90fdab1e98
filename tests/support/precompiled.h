#pragma once
/// What nearly all tests include, for the compiler to parse once; tests include what they use all the same.

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
