//! The style of all pictures: a CSS class per meaning, with a light and a dark colour.
//!
//! Hues are after Okabe and Ito (2008), so that colour-blind readers can distinguish them. Shapes repeat the meaning of colours.

use std::fmt::Write;

/// Name of a colour, and its value on a light and on a dark background.
const COLOURS: [(&str, &str, &str); 38] = [
    ("paper", "#ffffff", "#14181d"),
    ("ink", "#1d242c", "#e8ecf0"),
    ("quiet", "#5b6672", "#9aa7b4"),
    ("rule", "#d5dbe1", "#39424c"),
    ("card", "#f5f7f9", "#1c2229"),
    ("surface", "#fbf6ec", "#23282e"),
    ("outline", "#8a7a5c", "#8f8a7c"),
    ("obstacle", "#a9b0b7", "#59636d"),
    ("obstacle-line", "#5b6672", "#9aa7b4"),
    ("before", "#6f7b87", "#93a0ad"),
    ("left", "#0072b2", "#56b4e9"),
    ("done", "#009e73", "#2fc79b"),
    ("lost", "#a3347a", "#e59bc8"),
    ("node", "#d0390b", "#ff7a45"),
    ("goal", "#f5d90a", "#f5d90a"),
    ("goal-line", "#7a6a00", "#a38f00"),
    ("tool", "#56b4e9", "#56b4e9"),
    ("tool-line", "#0b5c8c", "#a6d8f5"),
    ("contact", "#d55e00", "#ff9548"),
    ("robot", "#d3d7dc", "#aab2bb"),
    ("robot-arm", "#8db4d9", "#79a9d6"),
    ("surface-3d", "#f3e3c3", "#cdbd9c"),
    ("limit", "#b3261e", "#ff8a80"),
    ("band-1", "#eef3f8", "#1d2935"),
    ("band-2", "#d9e6f1", "#22384b"),
    ("band-3", "#bfd6e9", "#294a64"),
    ("band-4", "#9fc3df", "#315d7f"),
    ("band-5", "#7aaed3", "#3b739d"),
    ("band-6", "#5596c5", "#498bbb"),
    ("band-7", "#347cb3", "#64a6d4"),
    ("band-8", "#1b609a", "#8cc3e8"),
    ("felt-free", "#1d242c", "#8d99a6"),
    ("felt-1", "#123a2c", "#3d6656"),
    ("felt-2", "#115a41", "#338063"),
    ("felt-3", "#0c7a56", "#2f9f79"),
    ("felt-4", "#079665", "#35c797"),
    ("felt-5", "#0fb573", "#66f5c2"),
    ("plane", "#7440b8", "#b594f2"),
];

/// Number of bands of a density.
pub(crate) const BANDS: usize = 8;

/// CSS rules of the classes, with colours as `{name}`.
const RULES: &str = "\
.ground{fill:{paper}}\
.text{fill:{ink};font-family:Inter,system-ui,sans-serif;font-size:13px}\
.strong{font-weight:600}\
.quiet{fill:{quiet}}\
.small{font-size:11px}\
.rule{stroke:{rule};stroke-width:1;fill:none}\
.axis{stroke:{quiet};stroke-width:1;fill:none}\
.surface{fill:{surface};stroke:none}\
.outline{fill:none;stroke:{outline};stroke-width:1.5}\
.skim-edge{fill:none;stroke:{goal-line};stroke-width:7}\
.skim-core{fill:none;stroke:{goal};stroke-width:4;stroke-dasharray:10 5}\
.obstacle{fill:{obstacle};stroke:{obstacle-line};stroke-width:1.5;fill-rule:evenodd}\
.before{fill:none;stroke:{before};stroke-width:1.1}\
.on-density .before{stroke:{ink};stroke-opacity:.65}\
.dots-left{fill:none;stroke:{left};stroke-linecap:round}\
.dots-done{fill:none;stroke:{done};stroke-linecap:round}\
.mark-lost{fill:none;stroke:{lost};stroke-width:1.6}\
.edge{fill:none;stroke:{ink};stroke-width:1.8;stroke-linejoin:round}\
.arrow{fill:{ink};stroke:none}\
.lifted{fill:none;stroke:{quiet};stroke-width:1.2;stroke-dasharray:5 4}\
.node{fill:{node};stroke:{paper};stroke-width:1.2}\
.node-cut{fill:{paper};stroke:{node};stroke-width:1.8}\
.number{fill:{paper};font-family:Inter,system-ui,sans-serif;font-weight:600;text-anchor:middle}\
.goal{fill:{goal};stroke:{goal-line};stroke-width:1.5}\
.goal-reach{fill:{goal};fill-opacity:.13;stroke:{goal-line};stroke-width:1.5;stroke-dasharray:3 3}\
.tool{fill:{tool};fill-opacity:.38;stroke:{tool-line};stroke-width:1.6;fill-rule:evenodd}\
.start{fill:{paper};stroke:{tool-line};stroke-width:2}\
.trail{fill:none;stroke:{tool-line};stroke-opacity:.55;stroke-width:1.4;stroke-linejoin:round}\
.curve{fill:none;stroke:{done};stroke-width:2.4;stroke-linejoin:round}\
.under{fill:{done};fill-opacity:.12;stroke:none}\
.cursor{stroke:{node};stroke-width:1.6;fill:none}\
.cursor-dot{fill:{node};stroke:{paper};stroke-width:1.5}\
.contour{stroke:{paper};stroke-opacity:.35;stroke-width:.6;fill-rule:evenodd}\
.band-1{fill:{band-1}}.band-2{fill:{band-2}}.band-3{fill:{band-3}}.band-4{fill:{band-4}}\
.band-5{fill:{band-5}}.band-6{fill:{band-6}}.band-7{fill:{band-7}}.band-8{fill:{band-8}}\
.phase-contact{fill:{contact}}.phase-lifted{fill:{quiet};fill-opacity:.55}\
.robot-body{fill:{robot};stroke:{quiet};stroke-width:1}.robot-arm{fill:{robot-arm};stroke:{quiet};stroke-width:1}\
.while-contact{fill:{contact};fill-opacity:.13;stroke:none}\
.forbidden{fill:{limit};fill-opacity:.1;stroke:none}\
.limit{fill:none;stroke:{limit};stroke-width:1.2;stroke-dasharray:5 3}\
.course{fill:none;stroke:{left};stroke-width:1.6;stroke-linejoin:round}\
.surface-plan{fill:{surface-3d};fill-opacity:.75;stroke:{outline};stroke-width:1.5;fill-rule:evenodd}\
.obstacle-plan{fill:{obstacle};fill-opacity:.4;stroke:{obstacle-line};stroke-width:1.2}\
.carrier-plan{fill:{outline};fill-opacity:.3;stroke:{outline};stroke-width:1}\
.robot-plan{fill:{robot-arm};fill-opacity:.5;stroke:{ink};stroke-width:1.5}\
.contact-path{fill:none;stroke:{contact};stroke-width:1.8;stroke-linejoin:round}\
.driven{fill:none;stroke:{node};stroke-width:2.2;stroke-dasharray:2 4;stroke-linecap:round}\
.rate-rim{fill:none;stroke:{quiet};stroke-linecap:round}\
.mark-blocked{fill:none;stroke:{quiet};stroke-width:1.3}\
.rate-1{fill:none;stroke-linecap:round;stroke:{band-1}}.rate-2{fill:none;stroke-linecap:round;stroke:{band-2}}\
.rate-3{fill:none;stroke-linecap:round;stroke:{band-3}}.rate-4{fill:none;stroke-linecap:round;stroke:{band-4}}\
.rate-5{fill:none;stroke-linecap:round;stroke:{band-5}}.rate-6{fill:none;stroke-linecap:round;stroke:{band-6}}\
.rate-7{fill:none;stroke-linecap:round;stroke:{band-7}}.rate-8{fill:none;stroke-linecap:round;stroke:{band-8}}\
.felt-free{fill:none;stroke:{felt-free};stroke-width:.9;stroke-linecap:round;stroke-linejoin:round}\
.felt-weak{fill:none;stroke:{felt-2};stroke-width:1.8;stroke-linecap:round;stroke-linejoin:round}\
.felt-confident{fill:none;stroke:{felt-5};stroke-width:1.8;stroke-linecap:round;stroke-linejoin:round}\
.felt-false{fill:none;stroke:{limit};stroke-width:3.4;stroke-linecap:round;stroke-linejoin:round}\
.felt-1,.felt-2,.felt-3,.felt-4,.felt-5{fill:none;stroke-width:2.4;stroke-linecap:round;stroke-linejoin:round}\
.felt-1{stroke:{felt-1}}.felt-2{stroke:{felt-2}}.felt-3{stroke:{felt-3}}.felt-4{stroke:{felt-4}}.felt-5{stroke:{felt-5}}\
.believed-surface{fill:{surface};stroke:{outline};stroke-width:1.5;fill-rule:evenodd}\
.fitted-plane{fill:{plane};fill-opacity:.17;stroke:{plane};stroke-opacity:.7;stroke-width:.8;stroke-linejoin:round}\
.confident-band{fill:{felt-5};fill-opacity:.15;stroke:none}\
.collision{fill:{limit};fill-opacity:.22;stroke:none}\
.contact-lost{fill:{quiet};fill-opacity:.2;stroke:none}\
.true-push{fill:{goal};fill-opacity:.12;stroke:{goal-line};stroke-width:1;stroke-dasharray:3 3}\
.lane{fill:{quiet};fill-opacity:.1;stroke:none}\
.event-contact{fill:{felt-4}}.event-loss{fill:{quiet}}.event-collision{fill:{limit}}.event-stick{fill:{plane}}.event-push{fill:{goal};stroke:{goal-line};stroke-width:.8}\
.halo{paint-order:stroke;stroke:{paper};stroke-width:3;stroke-linejoin:round}\
.contact-time{fill:{felt-4};stroke:none}\
.beyond-limit{fill:{contact};stroke:none}\
.cell{stroke:none}.under-particles .cell{fill-opacity:.6}\
.dot-rim{fill:none;stroke:{paper};stroke-linecap:round}\
.bar-predicted{fill:{paper};stroke:{quiet};stroke-width:1.4;stroke-dasharray:4 2}\
.bar-estimated{fill:{left};stroke:none}.bar-true{fill:{ink};fill-opacity:.75;stroke:none}\
.whisker{fill:none;stroke:{ink};stroke-width:1.5}\
.end{text-anchor:end}.middle{text-anchor:middle}";

/// Returns the rules with literal light colours, for a picture in a file.
pub(crate) fn standalone_rules() -> String {
    COLOURS
        .iter()
        .fold(RULES.to_owned(), |rules, (name, light, _)| {
            rules.replace(&format!("{{{name}}}"), light)
        })
}

/// Returns the rules and colours of a page, which follows the reader's light or dark scheme.
pub(crate) fn page_rules() -> String {
    let mut css = String::from(":root{color-scheme:light dark;");
    for (name, light, _) in COLOURS {
        let _ = write!(css, "--{name}:{light};");
    }
    css.push_str("}@media (prefers-color-scheme:dark){:root{");
    for (name, _, dark) in COLOURS {
        let _ = write!(css, "--{name}:{dark};");
    }
    css.push_str("}}");
    css + &COLOURS.iter().fold(RULES.to_owned(), |rules, (name, ..)| {
        rules.replace(&format!("{{{name}}}"), &format!("var(--{name})"))
    })
}
