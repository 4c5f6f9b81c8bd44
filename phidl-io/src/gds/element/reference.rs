//! SREF and AREF: single references and arrays.

use super::fields::{Defect, Fields, put_properties, put_transform, text_of};
use crate::gds::record::{kind, put_mark, put_text, put_u16s, put_xy};
use crate::model::{CellNames, Corner, Lattice, Placement, Problems};

/// The single reference of an element.
pub(in crate::gds) fn read(
    fields: &mut Fields<'_>,
    names: &mut CellNames,
    cell: &str,
    problems: &mut Problems,
) -> Result<Placement, Defect> {
    fields.check()?;
    let [origin] = fields.points(cell, problems)?;
    placement(fields, origin, None, names, cell, problems)
}

/// The array of an element.
pub(in crate::gds) fn read_array(
    fields: &mut Fields<'_>,
    names: &mut CellNames,
    cell: &str,
    problems: &mut Problems,
) -> Result<Placement, Defect> {
    fields.check()?;
    let (columns, rows) = fields.columns_and_rows.ok_or("it states no columns and rows")?;
    if columns == 0 || rows == 0 {
        return Err(format!("it is an array of {columns} columns and {rows} rows").into());
    }
    let [origin, column_end, row_end] = fields.points(cell, problems)?;
    let extent = |end: Corner| [0, 1].map(|axis| i64::from(end[axis]) - i64::from(origin[axis]));
    let lattice = Lattice {
        columns: columns.into(),
        rows: rows.into(),
        column_extent: extent(column_end),
        row_extent: extent(row_end),
    };
    placement(fields, origin, Some(Box::new(lattice)), names, cell, problems)
}

fn placement(
    fields: &mut Fields<'_>,
    origin: Corner,
    lattice: Option<Box<Lattice>>,
    names: &mut CellNames,
    cell: &str,
    problems: &mut Problems,
) -> Result<Placement, Defect> {
    let magnification = fields.magnification()?.unwrap_or(1.0);
    let name = fields.name.ok_or("it names no cell")?;
    let properties = fields.properties();
    // The usual name is not copied: masks have millions of references.
    let child = match std::str::from_utf8(name.trimmed()) {
        Ok(name) => names.intern(name),
        Err(_) => names.intern(&text_of(&name, cell, problems)),
    };
    Ok(Placement {
        child,
        origin,
        x_reflection: fields.x_reflection(),
        magnification,
        rotation: fields.rotation(),
        lattice,
        properties: (!properties.is_empty()).then(|| Box::new(properties)),
        offset: fields.offset,
    })
}

/// Appends the records of a reference or an array. The ends of the lattice must fit 32 bits and the counts 16.
pub(in crate::gds) fn write(placement: &Placement, child: &str, bytes: &mut Vec<u8>) {
    let Placement { origin, x_reflection, magnification, rotation, .. } = *placement;
    put_mark(if placement.lattice.is_some() { kind::AREF } else { kind::SREF }, bytes);
    put_text(kind::SNAME, child, bytes);
    put_transform(x_reflection, (magnification != 1.0).then_some(magnification), rotation, bytes);
    match placement.lattice.as_deref() {
        None => put_xy([origin].iter(), bytes),
        Some(lattice) => {
            let count = |count: u32| u16::try_from(count).expect("invariant: arrays are cut to the counts of a record");
            put_u16s(kind::COLROW, [count(lattice.columns), count(lattice.rows)], bytes);
            let end = |extent: [i64; 2]| {
                [0, 1].map(|axis| {
                    i32::try_from(i64::from(origin[axis]) + extent[axis])
                        .expect("invariant: arrays are cut to the reach of a record")
                })
            };
            put_xy([origin, end(lattice.column_extent), end(lattice.row_extent)].iter(), bytes);
        }
    }
    if let Some(properties) = &placement.properties {
        put_properties(properties, bytes);
    }
    put_mark(kind::ENDEL, bytes);
}
