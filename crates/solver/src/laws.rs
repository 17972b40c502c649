//! The laws of contacts that are no clipped lines, with their numbers in the units of the structure.
//!
//! r and rdot are the relative displacement and velocity of the contact, S is its force, L the friction limit nu N. Impacts have the overlap
//! d = -r > 0 and push with F = -S. Each type says how it steps, stores and dissipates. F is a force, L a length and T a time in the
//! units; `limit` in a [`crate::StructureLaw`] is that of the structure.
//!
//! | law | S or F | numbers and units | source |
//! | --- | --- | --- | --- |
//! | [`Bearing`] | min(rdot/`compliance`, nu(rdot) N), nu = nu_max - (nu_max - nu_min) exp(-`rate` abs(rdot)) | `compliance` L/(T F), `limit` nu_max N in F, `ratio` nu_min/nu_max, `rate` T/L | Constantinou, Mokha and Reinhorn 1990 |
//! | [`Tanh`] | nu(rdot) N tanh(rdot/(`compliance` `limit`)) | as of [`Bearing`] | Andersson, Söderberg and Björklund 2007 |
//! | [`Stribeck`] | rdot/`compliance` up to `static_limit`, beyond it `limit` + (`static_limit` - `limit`) exp(-x), or /(1 + x) by `decay`, x = (abs(rdot) - rdot^E)/v | `compliance` L/(T F), both limits F, v = `stribeck_velocity` L/T | Tustin 1947; Bo and Pavelescu 1982 |
//! | [`Decay`] | how the force of [`Stribeck`] falls: exp(-x) or 1/(1 + x) | no number of its own | as of [`Stribeck`] |
//! | [`BoucWen`] | dS/dr = (1 - abs(S/L)^n (b sgn(rdot S) + 1 - b))/`compliance` | `compliance` L/F, `limit` F, n = `exponent`, b = `beta` | Bouc 1967, Wen 1976 |
//! | [`Dahl`] | dS/dr = (1 - (S/L) sgn rdot)^n/`compliance` | as of [`BoucWen`] | Dahl 1968 |
//! | [`Lugre`] | `sigma0` z + `sigma1` dz/dt + `sigma2` rdot, dz/dt = rdot - `sigma0` abs(rdot) z/g(rdot) | `sigma0` F/L, `sigma1` and `sigma2` F T/L, both limits F, `stribeck_velocity` L/T | Canudas de Wit et al. 1995 |
//! | [`Pendulum`] | friction with the limit nu N, and (N/R) r | `compliance` L/F, `limit` F, `restoring` 1/(nu R) in 1/L, `at_rest` F and 1, `rising` 1 and T/L | Zayas, Low and Mahin 1990 |
//! | [`KelvinVoigt`] | F = max(k d + c dd/dt, 0) | k = `stiffness` F/L, c = `damping` F T/L | Anagnostopoulos 1988 |
//! | [`Hertz`] | F = k d^1.5 | k = `stiffness` F/L^1.5 | Goldsmith 1960 |
//! | [`HertzDamp`] | F = k d^1.5 (1 + kappa (dd/dt)/v0), kappa = 3 (1 - e^2)/4, v0 the closing speed | k = `stiffness` F/L^1.5, kappa = `damping` | Lankarani and Nikravesh 1990 |
//! | [`HuntCrossley`] | the same with kappa = 3 (1 - e)/2 | as of [`HertzDamp`] | Hunt and Crossley 1975 |
//! | [`Ye`] | the same with kappa = 8 (1 - e)/(5 e) | as of [`HertzDamp`] | Ye, Li and Zhu 2009 |
//! | [`Jankowski`] | F = k d^1.5, with c d^0.25 dd/dt more while closing | k = `stiffness` F/L^1.5, c = `damping` F T/L^1.25 | Jankowski 2005, 2006 |
//! | [`GapYield`] | F = max(min(k (d - s), Fy (1 - eta) + eta k d), 0), s the gap that yielding leaves | k = `stiffness` F/L, Fy = `yield_force` F, eta = `hardening`, `damage` | OpenSees, `ElasticPPGap` |
//! | [`HyperbolicGap`] | F = max(min(k_u (d - s), d/(1/k + R_f d/F_ult)), 0) | k = `stiffness` and k_u = `unloading` F/L, F_ult = `ultimate` F, R_f = `failure_ratio` | Duncan and Mokwa 2001 |
//! | [`ImpactYield`] | F elastic with k1 between k2 d and k2 d + (k1 - k2) d_y | k1 = `stiffness` and k2 = `hardening` F/L, d_y = `yield_overlap` L | Muthukumar and DesRoches 2006 |
//! | [`Bilinear`] | S elastic with k1 between k2 r - q and k2 r + q, q = Fy (1 - k2/k1) | k1 = `stiffness` and k2 = `hardening` F/L, Fy = `yield_force` F | Prager 1956 |
//! | [`Restrainer`] | S = max(min(k (d - s), Fy (1 - eta) + eta k d), 0), d = r - `slack` | `slack` L, k = `stiffness` F/L, Fy = `yield_force` F, eta = `hardening` | OpenSees, `ElasticPPGap` |
//! | [`Viscous`] | S = c abs(rdot)^a sgn rdot | c = `viscosity` F (T/L)^a, a = `exponent` | OpenSees, `ViscousDamper` |
//! | [`Multilinear`] | S along a table of r and S, unloading by Masing's rule | points of L and F; [`Multilinear::new`] refuses a table whose slope rises | Iwan 1966 |
//! | [`Imk`] | a backbone that hardens, falls and degrades with the energy that it takes | stiffness F/L, forces F, deflections L | Ibarra, Medina and Krawinkler 2005 |
//!
//! A damper of 0.5 with the square of the velocity slows a mass of 2 with the speed 3 down to v(t) = 1/(1/3 + t/4):
//!
//! ```
//! use slipgap_solver::{
//!     AverageAcceleration, Contact, ContactLaw, Direction, Node, Structure, StructureLaw, laws::Viscous, run,
//! };
//!
//! let mut mass = Structure::new(vec![Node { name: "mass".into(), mass: 2.0, direction: Direction::X }]);
//! let damper = ContactLaw::Viscous(Viscous { viscosity: 0.5, exponent: 2.0 });
//! let law = StructureLaw::new(damper, None);
//! mass.contacts.push(Contact { name: "damper".into(), along: vec![(0, 1.0)], gap: 0.0, law });
//! mass.velocity[0] = 3.0;
//! let motion = run(&mass, &AverageAcceleration.into(), 0.001, 4000)?;
//! assert!((motion.velocity[4000][0] - 0.75).abs() < 1e-6);
//! # Ok::<(), slipgap_solver::Unsolvable>(())
//! ```

#[doc(inline)]
pub use slipgap_contact::contact::{
    Bearing, Bilinear, BoucWen, Dahl, Decay, GapYield, Hertz, HertzDamp, HuntCrossley,
    HyperbolicGap, Imk, ImpactYield, Jankowski, KelvinVoigt, Lugre, Multilinear, Pendulum,
    Restrainer, Stribeck, Tanh, Viscous, Ye,
};
