//! The spectrum of a file, or of a pair of files, whose ordinates decide a choice.

use super::cache::Cache;
use crate::source::faults::quoted;
use crate::source::folder::Folder;
use libm::log;
use slipgap_system::system::loads::measures::Measure;
use slipgap_system::system::loads::pair::Component;
use slipgap_system::system::loads::record::{self, Reading};
use slipgap_system::system::loads::signal;
use slipgap_system::system::loads::spectrum::{Ordinate, spectrum};
use slipgap_system::system::structure::{Signal, Table};

/// Most bytes of a record.
const LARGEST: u64 = 64 << 20;

/// Which ordinates are computed.
pub(super) struct Ordinates {
    pub periods: Vec<f64>,
    pub ratio: f64,
    /// Of what of pairs, if they are chosen.
    pub component: Option<Component>,
}

impl Ordinates {
    /// The logarithms of the pseudo-accelerations of a motion, in m/s2, from its file or both files.
    ///
    /// # Errors
    /// The file that is no record, or has no spectrum.
    pub fn logarithms(
        &self,
        folder: &Folder,
        files: &[String],
        cache: &Cache,
    ) -> Result<Vec<f64>, String> {
        let read = |file: &String| {
            let bytes = folder.bytes(file, LARGEST);
            bytes.map_err(|why| format!("{}: {why}", quoted(file)))
        };
        let contents = files.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        // A pair also has the name of its component, and the length of the first file, after which the second one begins.
        let numbers = self.periods.iter().chain([&self.ratio]).copied();
        let key = match (self.component, &contents[..]) {
            (Some(component), [x, _]) => {
                let both = [component.name().as_bytes(), &contents.concat()].concat();
                Cache::key(&both, numbers.chain([x.len() as f64]))
            }
            (_, contents) => Cache::key(&contents.concat(), numbers),
        };
        if let Some(known) = cache.read(&key, self.periods.len()) {
            return Ok(known);
        }
        let both = files.iter().zip(&contents);
        let tables = both.map(|(file, content)| table(file, content));
        let values = self.values(&tables.collect::<Result<Vec<_>, _>>()?);
        let logarithms: Vec<f64> = values.unwrap_or_default().into_iter().map(log).collect();
        if logarithms.is_empty() || logarithms.iter().any(|x| !x.is_finite()) {
            let names: Vec<String> = files.iter().map(|file| quoted(file)).collect();
            return Err(format!(
                "{}: has no spectrum at these periods",
                names.join(", ")
            ));
        }
        cache.write(&key, &logarithms);
        Ok(logarithms)
    }

    /// The pseudo-accelerations of a motion or of a pair.
    fn values(&self, tables: &[Table]) -> Option<Vec<f64>> {
        match (tables, self.component) {
            ([x, y], Some(component)) => {
                let of = |period: &f64| {
                    let (period, ratio) = (*period, self.ratio);
                    component.of([x, y], Measure::Spectral { period, ratio })
                };
                self.periods.iter().map(of).collect()
            }
            (tables, _) => {
                let ordinates = spectrum(tables.first()?, &self.periods, self.ratio)?;
                let values = ordinates.iter().map(Ordinate::pseudo_acceleration);
                Some(values.collect())
            }
        }
    }
}

/// The acceleration of a file.
fn table(file: &str, content: &[u8]) -> Result<Table, String> {
    let at_fault = |why: String| format!("{}: {why}", quoted(file));
    let read = record::parse(file, content, Reading::default())
        .map_err(|fault| at_fault(format!("line {}: {}", fault.line, fault.cause)))?;
    let signal = signal(&read, None, 1.0).map_err(|why| at_fault(why.to_string()))?;
    match &*signal {
        Signal::Table(table) => Ok(table.clone()),
        Signal::Sine { .. } | Signal::Motion(..) => Err(at_fault("has no table".to_owned())),
    }
}
