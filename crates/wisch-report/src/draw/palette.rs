//! The style of all pictures: a CSS class per meaning, with a light and a dark colour.
//!
//! Names that the page's style sheet (`wisch-web`) also has have its colours, which its tests check: contrast, and differences for
//! colour-blind readers. Shapes repeat the meaning of colours.

use std::fmt::Write;

/// Name of a colour, and its value on a light and on a dark background.
const COLOURS: [(&str, &str, &str); 43] = [
    ("paper", "#ffffff", "#12161b"),
    ("ink", "#1b222a", "#e6ebf0"),
    ("quiet", "#56616d", "#9fabb7"),
    ("rule", "#cfd6dd", "#3a444f"),
    ("card", "#f5f7f9", "#1a2027"),
    ("ground", "#fbf6ec", "#23262a"),
    ("outline", "#8a7a5c", "#a89b80"),
    ("obstacle", "#d8d5cf", "#2f3338"),
    ("obstacle-line", "#5b6672", "#9aa7b4"),
    ("before", "#6f7b87", "#93a0ad"),
    ("believed", "#0d55a5", "#5bb8ff"),
    ("estimated", "#0e6e53", "#2fb280"),
    ("actual", "#7d046d", "#e1a0c8"),
    ("found", "#0e6e53", "#2fb280"),
    ("good", "#00694d", "#5fdcb2"),
    ("bad", "#9b2218", "#ff9d94"),
    ("node", "#db3900", "#ff8820"),
    ("goal", "#f0c800", "#6b5f0c"),
    ("goal-line", "#6a4000", "#f6cd8f"),
    ("target", "#6a4000", "#f6cd8f"),
    ("tool", "#14829e", "#10e8fd"),
    ("tool-line", "#0b5c8c", "#a6d8f5"),
    ("contact", "#db3900", "#ff8820"),
    ("pushed", "#7f7942", "#fbfa43"),
    ("collision", "#bd3e67", "#ff16b4"),
    ("event", "#7837f5", "#927af8"),
    ("body-1", "#d9dde1", "#aab2bb"),
    ("arm-1", "#9fc0de", "#7fabd3"),
    ("surface-3d", "#f4e8cd", "#3d3427"),
    ("band-1", "#eef3f8", "#1d2935"),
    ("band-2", "#d9e6f1", "#22384b"),
    ("band-3", "#bfd6e9", "#294a64"),
    ("band-4", "#9fc3df", "#315d7f"),
    ("band-5", "#7aaed3", "#3b739d"),
    ("band-6", "#5596c5", "#498bbb"),
    ("band-7", "#347cb3", "#64a6d4"),
    ("band-8", "#1b609a", "#8cc3e8"),
    ("touch-free", "#1d242c", "#8d99a6"),
    ("touch-1", "#123a2c", "#3d6656"),
    ("touch-2", "#115a41", "#338063"),
    ("touch-3", "#0c7a56", "#2f9f79"),
    ("touch-4", "#079665", "#35c797"),
    ("touch-5", "#0fb573", "#66f5c2"),
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
.surface{fill:{ground};stroke:none}\
.outline{fill:none;stroke:{outline};stroke-width:1.5}\
.skim-edge{fill:none;stroke:{goal-line};stroke-width:7}\
.skim-core{fill:none;stroke:{goal};stroke-width:4;stroke-dasharray:10 5}\
.obstacle{fill:{obstacle};stroke:{obstacle-line};stroke-width:1.5;fill-rule:evenodd}\
.before{fill:none;stroke:{before};stroke-width:1.1}\
.on-density .before{stroke:{ink};stroke-opacity:.65}\
.dots-left{fill:none;stroke:{believed};stroke-linecap:round}\
.dots-done{fill:none;stroke:{good};stroke-linecap:round}\
.mark-lost{fill:none;stroke:{bad};stroke-width:1.6}\
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
.curve{fill:none;stroke:{believed};stroke-width:2.4;stroke-linejoin:round}\
.under{fill:{believed};fill-opacity:.12;stroke:none}\
.cursor{stroke:{node};stroke-width:1.6;fill:none}\
.cursor-dot{fill:{node};stroke:{paper};stroke-width:1.5}\
.contour{stroke:{paper};stroke-opacity:.35;stroke-width:.6;fill-rule:evenodd}\
.band-1{fill:{band-1}}.band-2{fill:{band-2}}.band-3{fill:{band-3}}.band-4{fill:{band-4}}\
.band-5{fill:{band-5}}.band-6{fill:{band-6}}.band-7{fill:{band-7}}.band-8{fill:{band-8}}\
.phase-contact{fill:{contact}}.phase-lifted{fill:{quiet};fill-opacity:.55}\
.robot-body{fill:{body-1};stroke:{quiet};stroke-width:1}.robot-arm{fill:{arm-1};stroke:{quiet};stroke-width:1}\
.while-contact{fill:{contact};fill-opacity:.13;stroke:none}\
.forbidden{fill:{bad};fill-opacity:.1;stroke:none}\
.limit{fill:none;stroke:{bad};stroke-width:1.2;stroke-dasharray:5 3}\
.target{fill:none;stroke:{target};stroke-width:1.2;stroke-dasharray:5 3}\
.course{fill:none;stroke:{believed};stroke-width:1.6;stroke-linejoin:round}\
.surface-plan{fill:{surface-3d};fill-opacity:.75;stroke:{outline};stroke-width:1.5;fill-rule:evenodd}\
.obstacle-plan{fill:{obstacle};fill-opacity:.4;stroke:{obstacle-line};stroke-width:1.2}\
.carrier-plan{fill:{outline};fill-opacity:.3;stroke:{outline};stroke-width:1}\
.robot-plan{fill:{arm-1};fill-opacity:.5;stroke:{ink};stroke-width:1.5}\
.contact-path{fill:none;stroke:{contact};stroke-width:1.8;stroke-linejoin:round}\
.driven{fill:none;stroke:{node};stroke-width:2.2;stroke-dasharray:2 4;stroke-linecap:round}\
.rate-rim{fill:none;stroke:{quiet};stroke-linecap:round}\
.mark-blocked{fill:none;stroke:{quiet};stroke-width:1.3}\
.rate-1{fill:none;stroke-linecap:round;stroke:{band-1}}.rate-2{fill:none;stroke-linecap:round;stroke:{band-2}}\
.rate-3{fill:none;stroke-linecap:round;stroke:{band-3}}.rate-4{fill:none;stroke-linecap:round;stroke:{band-4}}\
.rate-5{fill:none;stroke-linecap:round;stroke:{band-5}}.rate-6{fill:none;stroke-linecap:round;stroke:{band-6}}\
.rate-7{fill:none;stroke-linecap:round;stroke:{band-7}}.rate-8{fill:none;stroke-linecap:round;stroke:{band-8}}\
.touch-free{fill:none;stroke:{touch-free};stroke-width:.9;stroke-linecap:round;stroke-linejoin:round}\
.touch-weak{fill:none;stroke:{touch-2};stroke-width:1.8;stroke-linecap:round;stroke-linejoin:round}\
.touch-confident{fill:none;stroke:{touch-5};stroke-width:1.8;stroke-linecap:round;stroke-linejoin:round}\
.touch-false{fill:none;stroke:{collision};stroke-width:3.4;stroke-linecap:round;stroke-linejoin:round}\
.touch-1,.touch-2,.touch-3,.touch-4,.touch-5{fill:none;stroke-width:2.4;stroke-linecap:round;stroke-linejoin:round}\
.touch-1{stroke:{touch-1}}.touch-2{stroke:{touch-2}}.touch-3{stroke:{touch-3}}.touch-4{stroke:{touch-4}}.touch-5{stroke:{touch-5}}\
.believed-surface{fill:{ground};stroke:{outline};stroke-width:1.5;fill-rule:evenodd}\
.fitted-plane{fill:{found};fill-opacity:.17;stroke:{found};stroke-opacity:.7;stroke-width:.8;stroke-linejoin:round}\
.confident-band{fill:{touch-5};fill-opacity:.15;stroke:none}\
.collision{fill:{collision};fill-opacity:.22;stroke:none}\
.contact-lost{fill:{quiet};fill-opacity:.2;stroke:none}\
.true-push{fill:{actual};fill-opacity:.12;stroke:{actual};stroke-width:1;stroke-dasharray:3 3}\
.lane{fill:{quiet};fill-opacity:.1;stroke:none}\
.event-contact{fill:{contact}}.event-loss{fill:{quiet}}.event-collision{fill:{collision}}.event-guided{fill:{pushed}}.event-stick{fill:{event}}.event-push{fill:{actual}}\
.halo{paint-order:stroke;stroke:{paper};stroke-width:3;stroke-linejoin:round}\
.contact-time{fill:{contact};stroke:none}\
.beyond-limit{fill:{bad};stroke:none}\
.cell{stroke:none}.under-particles .cell{fill-opacity:.6}\
.dot-rim{fill:none;stroke:{paper};stroke-linecap:round}\
.bar-predicted{fill:{paper};stroke:{quiet};stroke-width:1.4;stroke-dasharray:4 2}\
.bar-estimated{fill:{estimated};stroke:none}.bar-true{fill:{actual};stroke:none}\
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
