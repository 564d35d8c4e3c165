// SPDX-License-Identifier: Apache-2.0
// The list of commands.
#include "command.hpp"

#include <array>

namespace feelem::cli {
namespace {

constexpr std::array kCommands{
    Command{
        "convert",
        "Convert results to a scene or to another format",
        "INPUT... -o OUT",
        Takes::Inputs | Takes::Reading | Takes::Output | Takes::Model | Takes::Levels,
        run_convert},
    Command{
        "info",
        "Say what is in the files: mesh, parts, steps, results with ranges, skin",
        "INPUT... | SCENE [--brief] [--json]",
        Takes::Inputs | Takes::Reading | Takes::Model | Takes::Brief | Takes::Json,
        run_info},
    Command{
        "view",
        "Show results or a scene in the browser",
        "INPUT... | SCENE [--port N] [--lan] [--no-open]",
        Takes::Inputs | Takes::Reading | Takes::Model | Takes::Levels | Takes::Serving,
        run_view},
    Command{
        "probe",
        "Say every value at a node, a point or where a ray meets the skin",
        "SCENE | INPUT... --node ID | --point X,Y,Z | --ray OX,OY,OZ,DX,DY,DZ [--json]",
        Takes::Inputs | Takes::Reading | Takes::Model | Takes::Place | Takes::Json,
        run_probe},
    Command{
        "check",
        "Verify a scene against its certificate, and against the inputs it was made of",
        "SCENE [INPUT...] [--json]",
        Takes::Inputs | Takes::Reading | Takes::Json,
        run_check},
    Command{"formats", "List what can be read and written", "[--json]", Takes::Json, run_formats},
    Command{"doctor", "Say what works on this machine", "", Takes::Nothing, run_doctor},
};

}  // namespace

std::span<const Command> commands() {
    return kCommands;
}

}  // namespace feelem::cli
