#include "core/format/json_keys.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace thetalane {
namespace {

constexpr std::size_t deepestPath = 8; // a scene needs four: bodies[1].position[0]

// Goes through the text once. The parser has vouched for its grammar, so that quotes, brackets and commas are
// all there is to look at.
class KeyWalk {
public:
    explicit KeyWalk(const QByteArray& json)
        : m_json(json) {}
    virtual ~KeyWalk() = default;

    void run() {
        for (; m_at < m_json.size(); ++m_at)
            step(m_json[m_at]);
    }

protected:
    struct Level {
        bool isObject = false;
        bool expectsKey = false;
        std::size_t index = 0;         // of the element, in an array
        std::string key;               // of the member, in an object
        std::vector<std::string> keys; // all so far
    };

    virtual void reached(qsizetype /*offset*/) {} // a member or an element; path() names it
    virtual void closed(const Level& /*object*/) {}

    std::size_t depth() const { return m_levels.size(); }

    std::string path() const {
        std::string text;
        for (const Level& level : m_levels) {
            if (!level.isObject)
                text += '[' + std::to_string(level.index) + ']';
            else
                text += (text.empty() ? "" : ".") + level.key;
        }
        return text;
    }

private:
    void step(char c) {
        if (c == '"')
            return string();
        if (c == '{' || c == '[') {
            m_levels.push_back({c == '{', c == '{', 0, {}, {}});
            if (c == '[')
                reached(m_at);
        } else if (c == '}' || c == ']') {
            const Level level = std::move(m_levels.back());
            m_levels.pop_back();
            if (level.isObject)
                closed(level);
        } else if (c == ',') {
            Level& level = m_levels.back();
            level.expectsKey = level.isObject;
            ++level.index;
            if (!level.isObject)
                reached(m_at);
        }
    }

    void string() {
        const qsizetype start = m_at++;
        bool escaped = false;
        for (; m_json[m_at] != '"'; ++m_at) {
            if (m_json[m_at] == '\\') {
                escaped = true;
                ++m_at;
            }
        }
        if (m_levels.empty() || !m_levels.back().expectsKey)
            return;
        Level& level = m_levels.back();
        level.expectsKey = false;
        const QByteArray raw = m_json.mid(start, m_at - start + 1);
        level.key = escaped ? unescaped(raw) : raw.mid(1, raw.size() - 2).toStdString();
        level.keys.push_back(level.key);
        reached(start);
    }

    static std::string unescaped(const QByteArray& quoted) {
        return QJsonDocument::fromJson('[' + quoted + ']').array().at(0).toString().toStdString();
    }

    const QByteArray& m_json;
    qsizetype m_at = 0;
    std::vector<Level> m_levels;
};

class DuplicateWalk : public KeyWalk {
public:
    using KeyWalk::KeyWalk;
    std::vector<std::string> found;

private:
    void closed(const Level& object) override {
        std::vector<std::string> keys = object.keys;
        std::sort(keys.begin(), keys.end());
        for (auto it = keys.begin(); (it = std::adjacent_find(it, keys.end())) != keys.end();) {
            const std::string parent = path();
            found.push_back(parent + (parent.empty() ? "" : ".") + *it);
            it = std::upper_bound(it, keys.end(), *it);
        }
    }
};

class OffsetWalk : public KeyWalk {
public:
    OffsetWalk(const QByteArray& json, const std::unordered_set<std::string>& paths)
        : KeyWalk(json)
        , m_paths(paths) {}
    std::unordered_map<std::string, qsizetype> found;

private:
    void reached(qsizetype offset) override {
        if (depth() > deepestPath)
            return; // nobody asks, and the names of a thousand levels are long
        const std::string here = path();
        if (m_paths.contains(here))
            found.emplace(here, offset);
    }
    const std::unordered_set<std::string>& m_paths;
};

} // namespace

std::vector<std::string> duplicateKeys(const QByteArray& json) {
    DuplicateWalk walk(json);
    walk.run();
    return std::move(walk.found);
}

std::unordered_map<std::string, qsizetype> keyOffsets(const QByteArray& json,
                                                      const std::unordered_set<std::string>& paths) {
    OffsetWalk walk(json, paths);
    walk.run();
    return std::move(walk.found);
}

std::string parentPath(const std::string& path) {
    const auto cut = path.find_last_of(".[");
    return cut == std::string::npos ? std::string() : path.substr(0, cut);
}

} // namespace thetalane
