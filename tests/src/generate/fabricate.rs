//! Fabricate blocks with random settings and requirements.

use super::Writer;
use super::scope::Kind;
use super::words::{EDGES, ENDS, GRAINS, PINS, REQUIREMENTS, SIDES};

impl Writer<'_> {
    pub(super) fn fabricate(&mut self) -> String {
        let Some(figure) = self.scope.figures.last().cloned() else {
            return "fabricate lost as panels { }\n".to_owned();
        };
        let panels = figure.surface != self.choices.rarely();
        let mut entries = if panels { self.panels() } else { self.planks() };
        if self.choices.chance(2) {
            entries.push(self.machine());
        }
        if self.choices.chance(4) {
            entries.push(format!("address: engraved(height: {})", self.expression(&Kind::Length)));
        }
        if self.choices.chance(16) {
            entries.push("scale: 1/20".to_owned());
        }
        for _ in 0..self.choices.below(4) {
            entries.push(self.requirement(panels));
        }
        let lines: String = entries.iter().map(|entry| format!("  {entry}\n")).collect();
        let kind = if panels { "panels" } else { "planks" };
        format!("fabricate {} as {kind} {{\n{lines}}}\n", figure.name)
    }

    /// A length that is sensible most of the time.
    fn sensible(&mut self, usual: &str) -> String {
        if self.choices.chance(5) { self.expression(&Kind::Length) } else { usual.to_owned() }
    }

    fn panels(&mut self) -> Vec<String> {
        let thickness = self.sensible("12mm");
        let mut entries = vec![
            format!("material: birch_plywood({thickness})"),
            format!("board: {} by {}", self.sensible("2500mm"), self.sensible("1250mm")),
        ];
        for (name, words) in [("side", SIDES), ("grain", GRAINS), ("edges", EDGES)] {
            if self.choices.chance(3) {
                entries.push(format!("{name}: {}", self.choices.pick(words)));
            }
        }
        if self.choices.chance(3) {
            entries.push(self.planarize());
        }
        entries
    }

    fn planarize(&mut self) -> String {
        let mut fields = vec![format!("iterations: {}", self.choices.below(30))];
        for name in ["worst", "average", "select", "threshold"] {
            if self.choices.chance(4) {
                fields.push(format!("{name}: {}", self.expression(&Kind::Number)));
            }
        }
        for name in ["step", "move"] {
            if self.choices.chance(4) {
                fields.push(format!("{name}: {}", self.expression(&Kind::Length)));
            }
        }
        if self.choices.chance(3) {
            fields.push(format!("pin: {}", self.choices.pick(PINS)));
        }
        format!("planarize: {{ {} }}", fields.join(", "))
    }

    fn planks(&mut self) -> Vec<String> {
        let mut entries = vec![
            "material: sawn_spruce".to_owned(),
            format!("section: {} by {}", self.sensible("120mm"), self.sensible("27mm")),
            format!("stock: {}", self.sensible("4m")),
        ];
        if self.choices.chance(2) {
            entries.push(format!("ends: {}", self.choices.pick(ENDS)));
        }
        if self.choices.chance(4) {
            entries.push(format!("gap: {}", self.sensible("2mm")));
        }
        entries
    }

    fn machine(&mut self) -> String {
        let mut arguments = vec![format!("tool: {}", self.sensible("6mm"))];
        for (name, usual) in [("flute", "50mm"), ("step_down", "6mm"), ("length", "3m"), ("height", "200mm")]
        {
            if self.choices.chance(6) {
                arguments.push(format!("{name}: {}", self.sensible(usual)));
            }
        }
        for (name, values) in
            [("feed", ["4m/min", "0m/min", "1e300m/min"]), ("spindle", ["18000rpm", "0rpm", "-1rpm"])]
        {
            if self.choices.chance(6) {
                arguments.push(format!("{name}: {}", self.choices.pick(&values)));
            }
        }
        format!("machine: router3({})", arguments.join(", "))
    }

    fn requirement(&mut self, panels: bool) -> String {
        let usual: &[&str] = if panels {
            &[
                "planarity >= 0.999",
                "edge in 10mm .. 3m",
                "bend radius >= material.min_bend_radius",
                "fold <= 5deg",
                "width >= 20mm",
                "angle in 20deg .. 160deg",
                "mass <= 80kg",
            ]
        } else {
            &["length in 10mm .. 3m", "mitre <= 45deg", "overlap >= 80mm", "count <= 500"]
        };
        let words =
            if self.choices.chance(3) { self.choices.pick(REQUIREMENTS) } else { self.choices.pick(usual) };
        format!("require {words}")
    }
}
