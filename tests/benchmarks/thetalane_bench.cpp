// thetalane_bench [--quick] [--only NAME]: what things cost on this machine, and what they do to energy,
// momentum and the discs, as Markdown tables. It asserts nothing about time; ctest runs it with --quick, only
// to see that it works.
#include "tests/benchmarks/tables.h"
#include "tests/benchmarks/worlds.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string_view>

using namespace thetalane::benchmarks;

namespace {

struct Part {
    std::string_view name;
    void (*print)(bool quick);
    bool onlyByName = false;
};
constexpr Part parts[] = {{"rack", rackTable},       {"lane", laneTable},
                          {"eleven", elevenTable},   {"gas", gasTables},
                          {"search", searchTable},   {"micro", microTable},
                          {"long", longTable, true}, {"longrun", longRunTable, true}};

struct Options {
    bool quick = false;
    std::string_view only;
    bool sound = true;
};

bool isPart(std::string_view name) {
    return std::any_of(std::begin(parts), std::end(parts), [name](const Part& p) { return p.name == name; });
}

Options parsed(int argc, char** argv) {
    Options o;
    for (int k = 1; k < argc; ++k) {
        const std::string_view arg = argv[k];
        if (arg == "--quick")
            o.quick = true;
        else if (arg == "--only" && k + 1 < argc && isPart(argv[k + 1]))
            o.only = argv[++k];
        else
            o.sound = false;
    }
    return o;
}

void explain() {
    std::puts(
        "Processor time. Contestants take turns, each repetition asks every one once; least and median of "
        "the\nrepetitions, spread: the middle half of them, of the median; ratio: of the medians, to the "
        "first row.\nOverlap: the deepest seen, in diameters of the pair (or of a body and a wall). Energy "
        "drift: against what\nit should be, relative to the start.");
    std::fputs(missingWorlds().c_str(), stdout);
}

} // namespace

int main(int argc, char** argv) {
    const Options options = parsed(argc, argv);
    if (!options.sound) {
        std::fputs("usage: thetalane_bench [--quick] [--only ", stderr);
        for (const Part& part : parts)
            std::fprintf(stderr, "%s%s", &part == parts ? "" : "|", part.name.data());
        std::fputs("]\n\"long\" and \"longrun\" take a minute and are run by name alone.\n", stderr);
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    explain();
    for (const Part& part : parts)
        if (options.only.empty() ? options.quick || !part.onlyByName : part.name == options.only)
            part.print(options.quick);
    return 0;
}
