//! NODE: electrical nets. They are kept and not drawn.

use super::fields::{Defect, Fields, put_layer, put_properties};
use crate::gds::record::{kind, put_mark, put_xy};
use crate::model::Node;

/// The node of an element.
pub(in crate::gds) fn read(fields: &mut Fields<'_>) -> Result<Node, Defect> {
    fields.check()?;
    let (layer, points) = (fields.layer()?, fields.corners()?.collect());
    Ok(Node { layer, points, properties: fields.properties(), offset: fields.offset })
}

/// Appends the records of a node.
pub(in crate::gds) fn write(node: &Node, bytes: &mut Vec<u8>) {
    put_mark(kind::NODE, bytes);
    put_layer(node.layer, kind::NODETYPE, bytes);
    put_xy(node.points.iter(), bytes);
    put_properties(&node.properties, bytes);
    put_mark(kind::ENDEL, bytes);
}
