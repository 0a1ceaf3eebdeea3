// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/record.h"

#include "core/check.h"

#include <nlohmann/json.hpp>

namespace jam {

using Json = nlohmann::ordered_json;

static Json rows(const Mat3& matrix) {
    Json out = Json::array();
    for (int row = 0; row < 3; ++row)
        out.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2)});
    return out;
}

static double number(const Json& value) {
    return value.is_null() ? Record::unknown : value.get<double>();
}

static Mat3 matrix(const Json& value) {
    Mat3 out;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            out(row, column) = number(
                value.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(column)));
    return out;
}

std::string json_line(const Record& record) {
    const Json line = {
        {"step", record.step},
        {"time", record.time},
        {"volume_fraction", record.volume_fraction},
        {"coordination", record.coordination},
        {"coordination_nr", record.coordination_nr},
        {"rattler_fraction", record.rattler_fraction},
        {"pressure", rows(record.pressure)},
        {"pressure_dynamic", rows(record.pressure_dynamic)},
        {"cundall", record.cundall},
        {"cundall_dynamic", record.cundall_dynamic},
        {"kinetic_energy_per_particle", record.kinetic_energy_per_particle},
        {"cell", rows(record.cell.transpose())},
        {"wall_seconds", record.wall_seconds},
        {"steps_per_second", record.steps_per_second},
    };
    return line.dump();
}

static Record record_from(const Json& line) {
    Record record;
    record.step = line.at("step").get<Count>();
    record.time = number(line.at("time"));
    record.volume_fraction = number(line.at("volume_fraction"));
    record.coordination = number(line.at("coordination"));
    record.coordination_nr = number(line.at("coordination_nr"));
    record.rattler_fraction = number(line.at("rattler_fraction"));
    record.pressure = matrix(line.at("pressure"));
    record.pressure_dynamic = matrix(line.at("pressure_dynamic"));
    record.cundall = number(line.at("cundall"));
    record.cundall_dynamic = number(line.at("cundall_dynamic"));
    record.kinetic_energy_per_particle = number(line.at("kinetic_energy_per_particle"));
    record.cell = matrix(line.at("cell")).transpose();
    record.wall_seconds = number(line.at("wall_seconds"));
    record.steps_per_second = number(line.at("steps_per_second"));
    return record;
}

Record record_from_json(const std::string& line) {
    try {
        return record_from(Json::parse(line));
    } catch (const Json::exception& reason) {
        throw InputError(
            fmt::format("record line '{}' is not a record of a run ({}); "
                        "remove the line, or start the run again in another folder",
                        line.substr(0, 60), reason.what()));
    }
}

}  // namespace jam
