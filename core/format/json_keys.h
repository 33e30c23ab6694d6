// What QJsonDocument does not keep of a file: where its keys stand, and keys that come twice in one object.
// Both take JSON that QJsonDocument has accepted.
#pragma once

#include <QByteArray>

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace thetalane {

// The paths (bodies[1].mass) of keys that an object has more than once, in the order of the file.
std::vector<std::string> duplicateKeys(const QByteArray& json);

// The byte at which each of the paths asked for stands, of those that are in the file.
std::unordered_map<std::string, qsizetype> keyOffsets(const QByteArray& json,
                                                      const std::unordered_set<std::string>& paths);

} // namespace thetalane
