//! StateBuffers for a state.

use super::series::Series;
use crate::exact::events::State;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::coordinates::modes::Modes;
use crate::exact::events::numerics::bernstein::{Polynomial, slope, value};

/// The numbers of a state.
pub struct StateBuffers {
    pub u: Vec<f64>,
    pub v: Vec<f64>,
    pub r: Vec<f64>,
    pub rate: Vec<f64>,
    pub force: Vec<f64>,
    pub slip: Vec<f64>,
    /// Values and rates of the modes.
    modes: [Vec<f64>; 2],
}

impl StateBuffers {
    /// Zeros.
    pub fn new(model: &Model) -> StateBuffers {
        let [u, v] = [(); 2].map(|()| vec![0.0; model.structure.len()]);
        let [r, rate, force, slip] = [(); 4].map(|()| vec![0.0; model.contacts.len()]);
        StateBuffers {
            u,
            v,
            r,
            rate,
            force,
            slip,
            modes: [(); 2].map(|()| vec![0.0; model.len()]),
        }
    }

    /// u and u' of these nodes at s of a piece of modes.
    pub fn modes_at(&mut self, modes: &Modes, series: &Series, s: f64, nodes: &[usize]) {
        let [u, v] = &mut self.modes;
        series.motion_at(s, u, v);
        let forces: Vec<Polynomial> = series
            .contacts
            .iter()
            .map(|contact| contact.force)
            .collect();
        let plates = series
            .flexible
            .as_ref()
            .map_or(&[][..], |flexible| &flexible.plates);
        let series_lists = [&series.loads[..], &forces, plates];
        let values =
            series_lists.map(|list| list.iter().map(|p| value(p, s)).collect::<Vec<f64>>());
        let rates = series_lists.map(|list| {
            list.iter()
                .map(|p| slope(p, s) / series.length)
                .collect::<Vec<f64>>()
        });
        for node in nodes {
            self.u[*node] = modes.at(*node, u, values.each_ref().map(|list| &list[..]));
            self.v[*node] = modes.at(*node, v, rates.each_ref().map(|list| &list[..]));
        }
    }

    /// The state.
    pub fn state(&self) -> State<'_> {
        State {
            u: &self.u,
            v: &self.v,
            r: &self.r,
            rate: &self.rate,
            force: &self.force,
            slip: &self.slip,
        }
    }
}
