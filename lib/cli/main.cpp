// SPDX-License-Identifier: GPL-3.0-or-later
#include <ios>

#include "cli/interruption.hpp"
#include "cli/program.hpp"

int main(int argc, char** argv) {
    using namespace sightline::detail;
    std::ios::sync_with_stdio(false);
    handle_interruptions();
    Program program;
    for (const auto add :
         {add_info, add_graph, add_view2, add_view3, add_path, add_transversals, add_skeleton,
          add_render, add_show, add_generate, add_check, add_torture})
        add(program);
    return static_cast<int>(program.run(argc, argv));
}
