//! One column of the results over another, a dot for each case.

use super::Draw;
use crate::column::{has_place, title, value, without_dot};
use crate::{DrawnCase, FigureData};
use slipgap_drawing::colour_map::bar;
use slipgap_drawing::layout;
use slipgap_drawing::layout::axis::Axis;
use slipgap_drawing::layout::cloud::Cloud;
use slipgap_drawing::layout::limits;
use slipgap_drawing::layout::sheet::{FilledMap, Panel, Sheet};
use slipgap_drawing::style;
use slipgap_drawing::text;
use slipgap_study::kinds::Scatter;

impl Draw for Scatter {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let Scatter {
            x,
            y,
            colour,
            scales,
        } = self;
        // A case has a dot if it has a place along both axes and the colour bar.
        let point = |shown: &DrawnCase| {
            let of = |column, scale| value(shown, column).filter(|x| has_place(scale, *x));
            let at = [of(*x, scales[0])?, of(*y, scales[1])?];
            match colour {
                Some(column) => Some((at, Some(of(*column, scales[2])?))),
                None => Some((at, None)),
            }
        };
        let points: Vec<([f64; 2], Option<f64>)> = cases.iter().filter_map(point).collect();
        let height = 190.0;
        let [x_range, y_range] = figure.ranges;
        let heights = limits::heights(points.iter().map(|(at, _)| at), x_range).into_iter();
        let y_axis = limits::axis(
            &title(study, *y),
            heights,
            scales[1],
            y_range,
            height / 24.0,
        );
        let colours: Option<Axis> = colour.map(|column| {
            let values = points.iter().filter_map(|(_, value)| *value);
            bar::axis(&title(study, column), values, scales[2], None)
        });
        let right = colours.as_ref().map_or(4.0, bar::room);
        let width = figure.width.unwrap_or(1.3 * style::SINGLE);
        let grid = layout::grid(width, 1, &[height], std::slice::from_ref(&y_axis), right);
        let places = points.iter().map(|(at, _)| at[0]);
        let most = grid.width / 40.0;
        let x_axis = limits::axis(&title(study, *x), places, scales[0], x_range, most);
        let frame = grid.frames[0][0];
        let mut panel = Panel::new(frame, grid.margin, x_axis, y_axis);
        let lacking = without_dot(points.len(), cases.len());
        // Over the frame if the title of the colour bar leaves space, or else under it.
        let beside = colours
            .as_ref()
            .map_or(0.0, |c| text::width(&c.title, style::TITLE));
        let room = width - frame.left - style::EDGE - beside;
        let over = text::width(&lacking, style::TITLE) + style::TITLE <= room;
        if over {
            panel.caption.clone_from(&lacking);
        }
        let count = points.len();
        panel.cloud = Some(Cloud::of(points.into_iter(), colours.as_ref(), count));
        let bar = Some(bar::frame(&frame));
        panel.map = colours.map(|colours| FilledMap::of_cells(Vec::new(), colours, bar));
        let mut sheet = Sheet {
            width,
            panels: vec![panel],
            ..Sheet::default()
        };
        layout::finish(&mut sheet, Vec::new(), figure.title.as_deref());
        if !over {
            layout::small_print(&mut sheet, &lacking);
        }
        sheet
    }
}
