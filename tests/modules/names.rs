//! Where the names of a crate lead, through imports and re-exports.

use std::collections::BTreeSet;

use crate::source::{Crate, Import, Module};

/// The names of a crate.
pub(crate) struct Names<'a>(&'a Crate);

/// The target of a path within the crate.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    Module(Vec<String>),
    /// An item, by the file that defines it.
    Item(usize),
}

/// Re-exports of re-exports; more are a circle of imports.
const DEEPEST: usize = 16;

impl<'a> Names<'a> {
    pub(crate) fn of(sources: &'a Crate) -> Self {
        Names(sources)
    }

    /// All pairs of files of which the first names something that the second defines.
    pub(crate) fn edges(&self) -> BTreeSet<(usize, usize)> {
        let mut edges = BTreeSet::new();
        for (path, module) in &self.0.modules {
            for used in self.used(module) {
                if let Some(Place::Item(file)) = self.resolve(path, &used, DEEPEST)
                    && file != module.file
                {
                    edges.insert((module.file, file));
                }
            }
        }
        edges
    }

    /// The paths in a module's code, and those of the imports that are not merely re-exports.
    fn used(&self, module: &Module) -> Vec<Vec<String>> {
        let imports = module.imports.iter().filter(|import| !import.public);
        let imports = imports.map(|import| import.path.clone());
        module.paths.iter().cloned().chain(imports).collect()
    }

    /// Where a path leads that stands in a module.
    fn resolve(&self, module: &[String], path: &[String], depth: usize) -> Option<Place> {
        let (first, rest) = path.split_first()?;
        let start = match first.as_str() {
            "crate" => Place::Module(Vec::new()),
            "self" => Place::Module(module.to_vec()),
            "super" => Place::Module(module[..module.len().checked_sub(1)?].to_vec()),
            name => self.lookup(module, name, depth)?,
        };
        rest.iter().try_fold(start, |place, name| match place {
            Place::Module(module) if name == "super" => Some(Place::Module(
                module[..module.len().checked_sub(1)?].to_vec(),
            )),
            Place::Module(module) => self.lookup(&module, name, depth),
            // A variant, or an associated item.
            item => Some(item),
        })
    }

    /// The meaning of a name in a module: a child, an item, or the target of an import.
    fn lookup(&self, path: &[String], name: &str, depth: usize) -> Option<Place> {
        let depth = depth.checked_sub(1)?;
        let module = self.0.modules.get(path)?;
        let child: Vec<String> = path.iter().cloned().chain([name.to_owned()]).collect();
        if module.items.iter().any(|item| item == name) {
            return Some(Place::Item(module.file));
        }
        if self.0.modules.contains_key(&child) {
            return Some(Place::Module(child));
        }
        let import = |wanted: &'static str| {
            let wanted = if wanted.is_empty() {
                name.to_owned()
            } else {
                wanted.to_owned()
            };
            module
                .imports
                .iter()
                .filter(move |import| import.name == wanted)
        };
        let named = |import: &Import| {
            // `use nalgebra;` would look for itself.
            let itself = import.path.len() == 1 && import.path[0] == name;
            (!itself)
                .then(|| self.resolve(path, &import.path, depth))
                .flatten()
        };
        let glob = |import: &Import| match self.resolve(path, &import.path, depth)? {
            Place::Module(module) if module != path => self.lookup(&module, name, depth),
            _ => None,
        };
        import("")
            .find_map(named)
            .or_else(|| import("*").find_map(glob))
    }
}
