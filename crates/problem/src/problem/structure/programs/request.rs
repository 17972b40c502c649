//! The request of a case: its equations in the units of the study, with the numbers that the steps of the product use.

use super::answer::FORMAT;
use super::asked::{Asked, name_and_direction};
use super::json::{Members, list, numbers, object};
use super::matrices::{both_triangles, influence};
use super::program::Program;
use super::scales::Scales;
use super::supports::of_supports;
use crate::contact::{ClippedLine, ContactKind};
use crate::problem::numbers::parameter::Value;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::Derived;
use crate::problem::structure::motions::derived;
use crate::problem::structure::motions::sweep::Ready;
use crate::solve::structure::forces_at_start;
use crate::system::structure::{Load, Signal, Structure};

/// What a request is made of.
pub(super) struct Request<'a> {
    pub problem: &'a StructureProblem,
    pub ready: &'a Ready,
    /// The structure of the case, or that with another start.
    pub structure: &'a Structure,
    /// The program; `None` for the request of a case by a method of the product.
    pub program: Option<&'a Program>,
    pub asked: &'a Asked,
    /// Whether long lists are in base64.
    pub base64: bool,
}

impl Request<'_> {
    /// The request in one line.
    ///
    /// # Errors
    /// What of the case the format does not have.
    pub(super) fn line(&self) -> Result<Vec<u8>, String> {
        let (structure, case) = (self.structure, &self.ready.case);
        let (dt, steps) = (self.ready.dt, self.ready.last);
        let contacts = self.contacts()?;
        let given = self.program.map_or(&[][..], |program| &program.numbers);
        let own: Vec<(&str, f64)> = given
            .iter()
            .map(|(name, amount)| match amount.value(case) {
                Ok(value) => Ok((name.as_str(), value)),
                Err(broken) => Err(format!("{}: {}", broken.parameter, broken.message)),
            })
            .collect::<Result<_, String>>()?;
        let ground = self.problem.template.ground.len();
        let is_motion = |load: &&Load| matches!(*load.signal, Signal::Motion(..));
        let of_supports_count = structure.loads.iter().filter(is_motion).count();
        let first_of_supports = structure.loads.len() - of_supports_count;
        let (loads, shaking) =
            structure.loads[..first_of_supports].split_at(first_of_supports - ground);
        let at_steps = |signal: &Signal, factor: f64| -> Vec<f64> {
            let values = signal.at_steps(dt, steps as usize).into_iter();
            values.map(|x| factor * x).collect()
        };
        let mut text = Vec::with_capacity(4096);
        object(&mut text, |members| {
            members.put("format", FORMAT);
            members.put("case", case.number);
            let study = self.problem.programs().study();
            members.put("study", study);
            members.object("parameters", |members| {
                let rows = case.schema.parameters.iter().zip(&case.values);
                for (parameter, value) in rows {
                    match value {
                        Some(Value::Number(x)) => members.put(&parameter.name, x),
                        Some(Value::Whole(n)) => members.put(&parameter.name, n),
                        Some(Value::Name(name)) => members.put(&parameter.name, name),
                        None => {}
                    }
                }
            });
            members.object("numbers", |members| {
                own.iter()
                    .for_each(|(name, value)| members.put(name, value));
            });
            members.put("units", &*self.problem.template.units);
            let scales = Scales::new(structure, dt, steps as usize);
            members.object("scales", |members| {
                members.put("length", scales.length);
                members.put("velocity", scales.velocity);
                members.put("force", scales.force);
            });
            members.put("dt", dt);
            members.put("steps", steps);
            let nodes = structure.nodes.iter();
            members.put("dofs", nodes.map(|node| &*node.name).collect::<Vec<_>>());
            for (name, matrix) in [
                ("M", &structure.mass()),
                ("K", &structure.stiffness),
                ("C", &structure.damping),
            ] {
                members.add(name, |text| both_triangles(text, matrix));
            }
            members.object("start", |members| self.start(members));
            members.object("loads", |members| {
                for (node, placed) in structure.nodes.iter().enumerate() {
                    let mut sum: Vec<f64> = Vec::new();
                    for load in loads {
                        let on_node = load.pattern.iter().filter(|(at, _)| *at == node);
                        let factor: f64 = on_node.map(|pair| pair.1).sum();
                        if factor == 0.0 {
                            continue;
                        }
                        sum.resize(steps as usize + 1, 0.0);
                        for (sum, x) in sum.iter_mut().zip(at_steps(&load.signal, factor)) {
                            *sum += x;
                        }
                    }
                    if !sum.is_empty() {
                        members.add(&placed.name, |text| numbers(text, &sum, self.base64));
                    }
                }
            });
            members.object("ground", |members| {
                let of_ground = self.problem.template.ground.iter().zip(shaking);
                for ((direction, motion), load) in of_ground {
                    let Ok((_, scale)) = motion.in_case(case, self.problem.template.metre) else {
                        continue;
                    };
                    members.object(direction.name(), |members| {
                        let a = at_steps(&load.signal, scale);
                        members.add("a", |text| numbers(text, &a, self.base64));
                        members.put("influence", influence(structure, load, scale));
                    });
                }
            });
            members.object("supports", |members| {
                of_supports(members, structure, (dt, steps as usize), self.base64);
            });
            members.add("contacts", |text| {
                list(text, &contacts, |text, contact| {
                    text.extend_from_slice(contact)
                });
            });
            let channels = self.asked.channels(structure).into_iter();
            let names: Vec<String> = channels.map(|(_, _, name)| name).collect();
            members.put("channels", names);
        });
        Ok(text)
    }

    /// u, v and a of the nodes, S of the contacts and the slip of friction at t = 0.
    fn start(&self, members: &mut Members) {
        let structure = self.structure;
        let nodes = 0..structure.len();
        let total = |which: usize, w: &[f64]| -> Vec<f64> {
            nodes
                .clone()
                .map(|node| structure.total(node, 0.0, which, w))
                .collect()
        };
        let (w, rate) = (&structure.displacement, &structure.velocity);
        members.put("u", total(0, w));
        members.put("v", total(1, rate));
        let forces = forces_at_start(structure);
        let zero = vec![0.0; structure.contacts.len()];
        let forces = forces.as_ref().unwrap_or(&zero);
        let derived: Vec<Derived> = nodes.clone().map(Derived::Acceleration).collect();
        let acceleration = derived::terms(structure, &derived).map(|terms| {
            let of_node = terms.into_iter().zip(&structure.nodes);
            let value = of_node.map(|(sum, node)| match node.mass > 0.0 {
                true => sum.value(|i| w[i], |i| rate[i], |c| forces[c], sum.at(0.0)),
                false => f64::NAN,
            });
            value.collect::<Vec<f64>>()
        });
        members.put("a", acceleration.unwrap_or_default());
        let contacts = || structure.contacts.iter().enumerate();
        let name = |c: usize| name_and_direction(structure, c).concat();
        members.object("S", |members| {
            contacts().for_each(|(c, _)| members.put(&name(c), forces[c]));
        });
        members.object("slip", |members| {
            for (c, contact) in contacts() {
                if contact.law.kind() != ContactKind::Friction {
                    continue;
                }
                let supports = structure.supports.iter();
                let moved = supports.map(|support| support.gaps[c] * support.motion.at(0.0)[0]);
                let r = structure.relative(c, w) + contact.gap + moved.sum::<f64>();
                let slip = match contact.law.line() {
                    Some(ClippedLine::Elastic { stiffness }) => r - forces[c] / stiffness,
                    _ => r,
                };
                members.put(&name(c), slip);
            }
        });
    }
}
