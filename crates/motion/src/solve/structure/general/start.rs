//! Structures at t = 0.

use super::critical::{CriticalFault, critical_fault};
use super::curved;
use super::stages::{General, Stage, Start};
use super::sub_step_contacts::{LaneContact, LaneLine};
use crate::lane::Lane;
use crate::solve::Unsolvable;
use crate::solve::structure::contacts::forces::Forces;
use crate::solve::structure::contacts::static_fault::static_ratio_fault;
use crate::solve::structure::contacts::static_friction::StaticFriction;
use crate::solve::structure::general::held::corrections::Corrections;
use crate::solve::structure::general::held::impacts::Impacts;
use crate::solve::structure::inputs::loads_at_steps::Inputs;
use crate::solve::structure::linear_part::moving::Moving;
use crate::solve::structure::{Prepared, start::initial};
use crate::system::structure::Structure;

impl<'a, const L: usize> General<'a, L> {
    /// The structures at t = 0, for this many steps.
    pub(in crate::solve::structure) fn new(
        cases: &[&Structure; L],
        prepared: &'a Prepared,
        steps: usize,
    ) -> Self {
        let (n, m, zero) = (prepared.nodes(), prepared.contacts(), Lane::splat(0.0));
        let parts = &prepared.sub_steps;
        let impulses = prepared.method.has_impulses();
        let explicit = parts.iter().any(|linear| linear.sub_step.is_explicit());
        let massless: Vec<usize> = prepared.massless_contacts().collect();
        let contact = |c| LaneContact::new(cases, c, explicit, &prepared.method);
        let contacts: Vec<_> = (0..m).map(contact).collect();
        let lines: Vec<Vec<_>> = parts
            .iter()
            .map(|linear| {
                let line =
                    |c| LaneLine::of(cases, c, &linear.sub_step, impulses, massless.contains(&c));
                (0..m).map(line).collect()
            })
            .collect();
        let of_parts = parts.iter().zip(&lines).map(|(linear, lines)| {
            let pairs = lines.iter().zip(&contacts);
            // A force that is known beforehand needs no compliance.
            let of = pairs.map(|(line, contact)| {
                let mut compliance = line.compliance;
                for (x, known) in compliance.0.iter_mut().zip(contact.known) {
                    *x = if known { 0.0 } else { *x };
                }
                (compliance, contact.bounds)
            });
            Forces::new(&linear.flexibility, of)
        });
        let mut forces: Vec<_> = of_parts.collect();
        let moving = Moving::new(cases, prepared.dt, &prepared.method);
        let mut stage = Stage {
            nodes: vec![[zero; 3]; n + 1],
            contacts: vec![[zero; 3]; m],
            gaps: moving
                .as_ref()
                .map_or(Vec::new(), |moving| moving.end.clone()),
        };
        let mut refused = [const { None }; L];
        for (l, case) in cases.iter().enumerate() {
            let fault = critical_fault(case, &prepared.method, prepared.dt);
            let words = |fault: CriticalFault| format!("{}: {fault}", fault.parameter());
            let two_limits = || {
                let (contact, why) = static_ratio_fault(case, &prepared.method)?;
                Some(format!("{}: {why}", case.contacts[contact].name))
            };
            let fault = fault
                .map(words)
                .or_else(|| curved::refused(case, prepared))
                .or_else(two_limits);
            refused[l] = fault.map(Unsolvable::BrokenRules);
            let start = initial::forces(case).unwrap_or_else(|why| {
                forces[0].fail(l, 0, why);
                vec![0.0; m]
            });
            let accelerations = case.accelerations(&start).unwrap_or_else(|why| {
                let node = case.nodes[why.row].name.clone();
                refused[l] = Some(Unsolvable::Indefinite { node });
                vec![0.0; n]
            });
            for (node, row) in prepared.place.iter().enumerate() {
                let [u, v, a] = &mut stage.nodes[*row];
                u.0[l] = case.displacement[node];
                v.0[l] = case.velocity[node];
                a.0[l] = accelerations[node];
            }
            for (contact, s) in stage.contacts.iter_mut().zip(start) {
                contact[2].0[l] = s;
            }
        }
        let weights: Vec<_> = parts.iter().map(|linear| linear.sub_step.weights).collect();
        let inputs = Inputs::of_sub_steps(cases, prepared, steps, &weights);
        let curved = curved::contacts(cases, parts, &mut forces);
        let mut state = General {
            prepared,
            curved,
            stages: vec![stage; parts.len() + 1],
            pressing: inputs.pressing(),
            inputs,
            impacts: Impacts::new(&contacts, prepared),
            corrections: Corrections::new(cases, &contacts, prepared).map(Box::new),
            knows: contacts.iter().any(|contact| contact.known.contains(&true)),
            contacts,
            lines,
            forces,
            step: 0,
            predicted: vec![[zero; 2]; n + 1],
            weighted: vec![[zero; 2]; n + 1],
            work: vec![zero; n + 1],
            trial: vec![zero; m],
            force: vec![zero; m],
            moving,
            refused,
            two_limits: StaticFriction::new(cases),
            start: Start::default(),
        };
        state.touch(parts.len());
        state
    }
}
