//! List of the figures, and a figure ready for drawing.

use plot::{BarChart, FaceChart, Picture, Size, StackedChart, Style, Theme, XyChart};
use quantities::unit::MILLIMETRE;
use quantities::{Language, Length, Measure};
use words::{capitalised, encoder, pictures, simulation, terminal, terms, wiring};

/// The figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// Limits in four quadrants with the cycle.
    TorqueSpeed,
    /// The cycle over time.
    Cycle,
    /// Every check as a bar.
    Utilisation,
    /// Torsion curve of the gear with its working point.
    Torsion,
    /// Loads on the output bearing over time.
    BearingLoad,
    /// Candidates by margin over mass or length.
    CandidateMap,
    /// Mating face of a connector; belongs to a code, not to a project.
    MatingFace,
    /// A run of the twin over time.
    Simulation,
    /// Frequency responses of its control.
    ControlLoops,
    /// Tracks of an encoder; belongs to a code, not to a project.
    EncoderTracks,
}

impl Figure {
    /// Figures of a project.
    pub const ALL: [Self; 6] =
        [Self::TorqueSpeed, Self::Cycle, Self::Utilisation, Self::Torsion, Self::BearingLoad, Self::CandidateMap];

    /// Returns the identifier, part of the contract with scripts.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::TorqueSpeed => "torque_speed",
            Self::Cycle => "cycle",
            Self::Utilisation => "utilisation",
            Self::Torsion => "torsion",
            Self::BearingLoad => "bearing_load",
            Self::CandidateMap => "candidate_map",
            Self::MatingFace => "mating_face",
            Self::Simulation => "simulation",
            Self::ControlLoops => "control_loops",
            Self::EncoderTracks => "encoder_tracks",
        }
    }

    /// Returns the figure of an identifier.
    #[must_use]
    pub fn of_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|figure| figure.id() == id)
    }

    /// Returns the title of the figure.
    #[must_use]
    pub fn title(self, language: Language) -> String {
        let title = match self {
            Self::TorqueSpeed => terms::torque_speed_plane,
            Self::Cycle => terms::cycle,
            Self::Utilisation => terms::utilisation,
            Self::Torsion => pictures::torsion_of_the_gear,
            Self::BearingLoad => pictures::load_on_the_output_bearing,
            Self::CandidateMap => terms::candidates,
            Self::MatingFace => wiring::mating_face,
            Self::Simulation => simulation::simulation,
            Self::ControlLoops => simulation::loops,
            Self::EncoderTracks => encoder::tracks,
        };
        capitalised(title(language))
    }
}

/// Permissible width and height of a picture \[mm\].
const SIDE_MM: std::ops::RangeInclusive<f64> = 40.0..=2000.0;

/// Returns a width or height in millimetres.
///
/// # Errors
/// The permissible range, if it is exceeded.
pub fn side_mm(asked: Length, language: Language) -> Result<f64, String> {
    let asked = asked.in_unit(&MILLIMETRE);
    if SIDE_MM.contains(&asked) {
        return Ok(asked);
    }
    Err(terminal::sides_of_a_picture(SIDE_MM.start(), SIDE_MM.end(), language))
}

/// A figure with its layout, not yet drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Kind of figure.
    pub figure: Figure,
    /// Title above the picture.
    pub title: String,
    /// Explanation of the picture, for a line below it.
    pub caption: String,
    /// Description of the picture in sentences with numbers; part of the picture, for screen readers.
    pub description: String,
    /// Suitable width and height \[mm\].
    pub size_mm: (f64, f64),
    pub(crate) chart: Chart,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Chart {
    Xy(XyChart),
    Stacked(StackedChart),
    Bars(BarChart),
    Face(FaceChart),
}

impl Drawing {
    pub(crate) fn new(
        figure: Figure,
        of: &str,
        size_mm: (f64, f64),
        (caption, description): (String, String),
        chart: Chart,
        language: Language,
    ) -> Self {
        let title = format!("{}: {of}", figure.title(language));
        let named = title.as_str();
        let chart = match chart {
            Chart::Xy(chart) => Chart::Xy(chart.title(named).description(&description)),
            Chart::Stacked(chart) => Chart::Stacked(chart.title(named).description(&description)),
            Chart::Bars(chart) => Chart::Bars(chart.title(named).description(&description)),
            Chart::Face(chart) => Chart::Face(chart.title(named).description(&description)),
        };
        Self { figure, title, caption, description, size_mm, chart }
    }

    /// Returns the suitable size of the figure.
    #[must_use]
    pub fn size(&self) -> Size {
        Size::millimetres(self.size_mm.0, self.size_mm.1)
    }

    /// Returns the style of the figure at a size; identifiers within the picture begin with that of the figure.
    #[must_use]
    pub fn style(&self, size: Size, theme: Theme, language: Language) -> Style {
        Style::new(size).theme(theme).language(language).id(&self.figure.id().replace('_', "-"))
    }

    /// Returns the curves of the figure as a tab-separated table, with the numbers in a language: one below the other,
    /// each with the headings of its two columns; next to each other if they share their first column. Empty without
    /// curves.
    #[must_use]
    pub fn curves(&self, language: Language) -> String {
        let (Some(x), blocks) = self.blocks() else { return String::new() };
        let head = |axis: &plot::PlaneAxis, label: &str| {
            let (symbol, unit) = axis.sign();
            let name = if label.is_empty() { symbol.to_owned() } else { format!("{symbol} {label}") };
            if unit.is_empty() { name } else { format!("{name} [{unit}]") }
        };
        // Every digit of a number, with the decimal mark of the language.
        let number = |value: f64| value.to_string().replace('.', &language.decimal_mark().to_string());
        let mut out = String::new();
        for block in &blocks {
            let heads = block.iter().map(|(y, line)| head(y, &line.label_text()));
            out += &[head(x, "")].into_iter().chain(heads).collect::<Vec<_>>().join("\t");
            out.push('\n');
            let Some((_, first)) = block.first() else { continue };
            for (row, (at, _)) in first.points().iter().enumerate() {
                let cells = block
                    .iter()
                    .map(|(_, line)| line.points().get(row).map_or_else(String::new, |point| number(point.1)));
                out += &[number(*at)].into_iter().chain(cells).collect::<Vec<_>>().join("\t");
                out.push('\n');
            }
            out.push('\n');
        }
        out
    }

    /// Draws the figure; the language of the style applies to its numbers.
    #[must_use]
    pub fn render(&self, style: &Style) -> Picture {
        match &self.chart {
            Chart::Xy(chart) => chart.render(style),
            Chart::Stacked(chart) => chart.render(style),
            Chart::Bars(chart) => chart.render(style),
            Chart::Face(chart) => chart.render(style),
        }
    }
}
