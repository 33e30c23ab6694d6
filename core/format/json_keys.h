// What QJsonDocument does not keep of a file: where its keys stand, and keys that come twice in one object.
// Both take JSON that QJsonDocument has accepted.
#pragma once

#include <QByteArray>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace thetalane {

// The paths (bodies[1].mass) of keys that an object has more than once, in the order of the file.
std::vector<std::string> duplicateKeys(const QByteArray& json);

// The byte at which each of the paths asked for stands, of those that are in the file.
std::unordered_map<std::string, qsizetype> keyOffsets(const QByteArray& json,
                                                      const std::unordered_set<std::string>& paths);

// bodies[1].mass -> bodies[1] -> bodies -> nothing
std::string parentPath(const std::string& path);

// A fault (with a `path`) stands where its key stands; one of a key that is missing, where the object begins
// that lacks it.
template <class Fault> void sortByPlace(std::vector<Fault>& faults, const QByteArray& json) {
    std::unordered_set<std::string> wanted;
    for (const Fault& f : faults)
        for (std::string p = f.path; !p.empty() && wanted.insert(p).second;)
            p = parentPath(p);
    const auto offsets = keyOffsets(json, wanted);
    std::vector<std::pair<qsizetype, Fault>> placed;
    placed.reserve(faults.size());
    for (Fault& f : faults) {
        std::string path = f.path;
        while (!path.empty() && !offsets.contains(path))
            path = parentPath(path);
        const qsizetype offset = path.empty() ? 0 : offsets.at(path);
        placed.emplace_back(offset, std::move(f));
    }
    std::stable_sort(placed.begin(), placed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < faults.size(); ++i)
        faults[i] = std::move(placed[i].second);
}

} // namespace thetalane
