// SPDX-License-Identifier: BSD-3-Clause
// The keys of a scene file: one table from which parser, writer, templates and documentation come.
#pragma once

#include "jamming/scene.h"
#include "jamming/scene_rules.h"
#include "jamming/scene_sizes.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jam {

/// A scene on its way from text or to it.
struct SceneDraft {
    SizesDraft sizes;
    Scene scene;  ///< its `sizes` are not used
};

/// The member of a draft that a key stands for, behind its rule.
struct SceneField {
    std::string rule;                                         ///< the values it takes, in words
    std::function<bool(SceneDraft&, const SceneValue&)> set;  ///< false: breaks the rule
    std::function<std::optional<SceneValue>(const SceneDraft&)> get;  ///< nothing: not given
};

struct SceneKey {
    std::string name;     ///< "table.key"
    std::string unit;     ///< empty: a pure number, or no number at all
    std::string meaning;  ///< in a few words
    SceneField field;
    std::string no_value = {};  ///< what holds where the key is not given and has no default value
    SceneValue example = {};    ///< keeps the rule; the default where there is one
    bool by_accuracy = false;   ///< protocol.accuracy gives its default
};

/// In the order in which a scene is written: table by table.
std::span<const SceneKey> scene_keys();
const SceneKey* find_scene_key(std::string_view name);

/// Names of the kinds that use this key of [sizes]; empty for keys of other tables.
std::vector<std::string> kinds_that_use(const SceneKey& key);

/// A value as TOML.
std::string toml_text(const SceneValue& value);

}  // namespace jam
