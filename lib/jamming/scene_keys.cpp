// SPDX-License-Identifier: BSD-3-Clause
#include "jamming/scene_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace jam {

/// What a field of the draft holds, as a value of its rule; nothing for an optional without one.
template <typename Rule, typename Field>
static std::optional<SceneValue> written(const Rule& rule, const Field& field) {
    if constexpr (requires { rule.write(field); }) {
        return rule.write(field);
    } else {
        return field ? rule.write(*field) : std::nullopt;
    }
}

/// The member at the end of a path of member pointers.
template <typename Object>
static auto& member_of(Object& object) {
    return object;
}
template <typename Object, typename First, typename... Rest>
static auto& member_of(Object& object, First first, Rest... rest) {
    return member_of(object.*first, rest...);
}

template <typename Rule, typename... Path>
static SceneField bound(const Rule& rule, Path... path) {
    SceneField out;
    out.rule = rule.text();
    out.set = [=](SceneDraft& draft, const SceneValue& value) {
        const auto read = rule.read(value);
        if (!read) return false;
        auto& member = member_of(draft, path...);
        member = static_cast<std::remove_reference_t<decltype(member)>>(*read);
        return true;
    };
    out.get = [=](const SceneDraft& draft) { return written(rule, member_of(draft, path...)); };
    return out;
}

static std::vector<SceneKey> sizes_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::sizes, member);
    };
    using Sizes = SizesDraft;
    Choice<std::string> kinds;
    for (const SizesKind& kind : sizes_kinds()) kinds.words.emplace_back(kind.name, kind.name);
    const Choice<Weight> weights{{{"volume", Weight::volume}, {"number", Weight::number}}};
    const Choice<DrawMethod> draws{
        {{"stratified", DrawMethod::stratified}, {"random", DrawMethod::random}}};
    const Whole particles{1, max_particle_count};
    return {
        {"sizes.kind", "", "the size distribution",  //
         in(kinds, &Sizes::kind), "required", "power-law"},
        {"sizes.alpha", "", "exponent: number density ~ D^(alpha - 4)",
         in(from(min_alpha, max_alpha), &Sizes::alpha), "required, or beta", 0.55},
        {"sizes.beta", "", "the same exponent as beta = 4 - alpha",
         in(from(4 - max_alpha, 4 - min_alpha), &Sizes::beta), "required, or alpha", 3.45},
        {"sizes.size_ratio", "", "lambda: largest over smallest diameter",
         in(from(1, max_size_ratio), &Sizes::size_ratio), "required; lognormal: exp(6 sigma)", 5},
        {"sizes.small_fraction", "", "f_S: volume of the small spheres over that of all",
         in(between(0, 1), &Sizes::small_fraction), "required", 0.25},
        {"sizes.large_count", "particles", "number of large spheres",
         in(particles, &Sizes::large_count), "required", 100},
        {"sizes.eta", "", "exponent of the cumulative volume fraction",
         in(from(0.05, 2.5), &Sizes::eta), "required", 0.6},
        {"sizes.sigma", "", "standard deviation of ln D",  //
         in(from(0.01, 1.5), &Sizes::sigma), "required", 0.3},
        {"sizes.file", "",
         "CSV file, relative to the scene file: diameters, or diameters and "
         "cumulative fractions",
         in(PathText{}, &Sizes::file), "required", "diameters.csv"},
        {"sizes.weight", "", "what the fractions of a cumulative curve count",
         in(weights, &Sizes::weight), "`\"volume\"`", "volume"},
        {"sizes.count", "particles", "number of particles", in(particles, &Sizes::count),
         "so many that 10 are above 0.95 of the largest diameter; a list of diameters: each once",
         5000},
        {"sizes.draw", "", "at evenly spaced quantiles, or at random by run.seed",
         in(draws, &Sizes::draw)},
    };
}

static std::vector<SceneKey> contact_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::contact, member);
    };
    const Choice<ContactLaw> laws{{{"hooke", ContactLaw::hooke}, {"hertz", ContactLaw::hertz}}};
    return {
        {"contact.law", "", "normal force: k overlap, or k sqrt(R_eff overlap) overlap",
         in(laws, &Material::law)},
        {"contact.stiffness", "force/length; hertz: pressure", "k",
         in(above(0), &Material::stiffness)},
        {"contact.damping", "1/time", "gamma of the damping force -M_eff gamma v_n",
         in(from(0, 1e6), &Material::damping)},
        {"contact.density", "mass/volume", "of the particles", in(above(0), &Material::density)},
    };
}

static std::vector<SceneKey> start_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::start, member);
    };
    return {
        {"start.volume_fraction", "", "of the random start without overlap",
         in(above(0, 0.6), &StartSettings::volume_fraction)},
        {"start.packing", "",
         "saved packing to start from in place of [sizes], relative to the "
         "scene file",
         in(PathText{}, &StartSettings::packing), "a random start", "packing.h5"},
    };
}

static std::vector<SceneKey> protocol_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::protocol, member);
    };
    using Protocol = ProtocolSettings;
    const Choice<ProtocolKind> kinds{
        {{"quasistatic", ProtocolKind::quasistatic}, {"nph", ProtocolKind::nph}}};
    const Choice<Accuracy> accuracies{
        {{"fast", Accuracy::fast}, {"standard", Accuracy::standard}, {"paper", Accuracy::paper}}};
    const Choice<FreeCell> cells{{{"all", FreeCell::all},
                                  {"orthogonal", FreeCell::orthogonal},
                                  {"isotropic", FreeCell::isotropic}}};
    const Choice<Masses> masses{
        {{"true", Masses::true_mass}, {"diameter", Masses::diameter}, {"equal", Masses::equal}}};
    return {
        {"protocol.kind", "", "the way to the jammed state", in(kinds, &Protocol::kind)},
        {"protocol.accuracy", "", "quasistatic: sets the keys that say so to a measured point",
         in(accuracies, &Protocol::accuracy)},
        {"protocol.pressure", "k/D_min; hertz: k", "applied pressure",
         in(PressureTensor{}, &Protocol::pressure)},
        {"protocol.free_cell", "", "what of the cell may change", in(cells, &Protocol::free_cell)},
        {"protocol.time_step", "tau = sqrt(M_min/k)", "\"automatic\": from the stiffest particle",
         in(RealOrAutomatic{above(0, 10)}, &Protocol::time_step)},
        {"protocol.masses", "", "nph: inertia of the particles; the equilibria do not depend on it",
         in(masses, &Protocol::masses)},
        {"protocol.cell_inertia", "", "factor on the inertia of the cell that N, k and D give",
         in(above(0, 1e6), &Protocol::cell_inertia)},
        {"protocol.cell_damping", "", "factor on the damping of the cell that goes with it",
         in(from(0, 1e6), &Protocol::cell_damping)},
    };
}

static std::vector<SceneKey> descent_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::protocol, &ProtocolSettings::descent,
                     member);
    };
    using Descent = DescentSettings;
    return {
        {"protocol.compaction_pressure", "k/D_min; hertz: k",
         "quasistatic: from where the pressure descends",
         in(RealOrAutomatic{above(0)}, &Descent::compaction_pressure)},
        {"protocol.compaction_steps", "steps", "quasistatic: of compaction, by inertia",
         in(Whole{0}, &Descent::compaction_steps)},
        {"protocol.descent_rate", "", "quasistatic: fastest fall of the pressure, of itself a step",
         in(above(0, 1), &Descent::rate)},
        {"protocol.descent_cundall", "",
         "quasistatic: Cundall parameter at which the pressure waits, where overlaps are 1e-4 or "
         "more",
         in(above(0, 1), &Descent::cundall)},
    };
}

static std::vector<SceneKey> stop_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::stop, member);
    };
    using Stop = StopSettings;
    return {
        {"stop.pressure", "", "largest error of the six pressures over the mean applied one",
         in(above(0, 1), &Stop::pressure)},
        {"stop.cundall", "", "Cundall parameter C", in(above(0, 1), &Stop::cundall)},
        {"stop.stability", "",
         "quasistatic: whether missing contacts and unstable modes are refused",
         in(YesNo{}, &Stop::stability)},
        {"stop.kinetic_energy", "energy", "nph: kinetic energy a particle",
         in(above(0), &Stop::kinetic_energy)},
        {"stop.volume_fraction_change", "", "nph: change of the volume fraction over the window",
         in(above(0, 1), &Stop::volume_fraction_change)},
        {"stop.coordination_change", "", "nph: change of the contacts a particle over the window",
         in(above(0, 100), &Stop::coordination_change)},
        {"stop.window", "steps", "nph: over which these changes are taken",
         in(Whole{1}, &Stop::window)},
        {"stop.max_steps", "steps", "limit; the state is saved there",
         in(Whole{0}, &Stop::max_steps)},
        {"stop.max_time", "s", "limit on the wall time of one sitting; 0: none",
         in(from(0), &Stop::max_time)},
    };
}

static std::vector<SceneKey> run_keys() {
    const auto in = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::run, member);
    };
    const auto in_lists = [](const auto& rule, auto member) {
        return bound(rule, &SceneDraft::scene, &Scene::run, &RunSettings::lists, member);
    };
    using Run = RunSettings;
    Choice<NeighborMethod> methods;
    for (const NamedNeighborMethod& one : neighbor_methods)
        methods.words.emplace_back(one.name, one.method);
    return {
        {"run.seed", "", "of everything random", in(Whole{0}, &Run::seed)},
        {"run.threads", "", "0: all that the machine has; the result does not depend on it",
         in(Whole{0, 4096}, &Run::threads)},
        {"run.record_interval", "steps", "between lines of record.jsonl",
         in(Whole{1}, &Run::record_interval)},
        {"run.checkpoint_interval", "steps", "between checkpoints",
         in(Whole{1}, &Run::checkpoint_interval)},
        {"run.output", "", "folder of the results, relative to where the program is started",
         in(PathText{}, &Run::output), "runs/NAME, after the scene file NAME.toml", "runs/mine"},
        {"run.neighbor_method", "", "how neighbors are searched; the other two cost more",
         in_lists(methods, &ListSettings::method)},
        {"run.collection_ratio", "",
         "largest over smallest diameter within a collection; \"automatic\": by a model of the "
         "cost",
         in_lists(RealOrAutomatic{above(1, max_size_ratio)}, &ListSettings::collection_ratio)},
    };
}

static bool differs_by_accuracy(const SceneKey& key) {
    if (key.name == "protocol.accuracy") return false;
    return std::ranges::any_of(std::array{Accuracy::fast, Accuracy::paper}, [&](Accuracy accuracy) {
        SceneDraft draft;
        draft.scene.protocol.accuracy = accuracy;
        take_defaults_of_accuracy(draft.scene);
        return key.field.get(draft) != key.field.get(SceneDraft{});
    });
}

static std::vector<SceneKey> all_keys() {
    std::vector<SceneKey> keys;
    for (auto table :
         {sizes_keys, contact_keys, start_keys, protocol_keys, descent_keys, stop_keys, run_keys})
        std::ranges::move(table(), std::back_inserter(keys));
    for (SceneKey& one : keys) {
        if (one.example.index() == 0) one.example = *one.field.get(SceneDraft{});
        one.by_accuracy = differs_by_accuracy(one);
    }
    return keys;
}

std::span<const SceneKey> scene_keys() {
    static const std::vector<SceneKey> keys = all_keys();
    return keys;
}

const SceneKey* find_scene_key(std::string_view name) {
    const auto at = std::ranges::find(scene_keys(), name, &SceneKey::name);
    return at == scene_keys().end() ? nullptr : &*at;
}

std::vector<std::string> kinds_that_use(const SceneKey& key) {
    std::vector<std::string> out;
    for (const SizesKind& kind : sizes_kinds())
        if (kind.takes(key.name)) out.push_back(kind.name);
    return out;
}

namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += fmt::format("\\{}", c);
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

struct AsToml {
    std::string operator()(std::monostate) const { return "nothing"; }
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(Count number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return number_text(number); }
    std::string operator()(const std::string& text) const { return quoted(text); }
    std::string operator()(const std::vector<double>& numbers) const {
        std::string out;
        for (const double number : numbers) out += (out.empty() ? "" : ", ") + number_text(number);
        return fmt::format("[{}]", out);
    }
};

}  // namespace

std::string toml_text(const SceneValue& value) {
    return std::visit(AsToml{}, value);
}

}  // namespace jam
