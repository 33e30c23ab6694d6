// What nearly every file of the window reads: compiled once. No file relies on it.
#pragma once

#include <QtWidgets>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>
