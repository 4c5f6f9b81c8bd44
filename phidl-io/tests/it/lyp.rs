//! Layer properties: what KLayout writes, and what a layer set becomes.

use phidl_core::layer::{Layer, LayerSet, NamedLayer};
use phidl_io::IoError;
use phidl_io::lyp::{self, CustomLine, CustomPattern, LayerView, LineStyle, Lyp, LypNames, Pattern, Source, View};

/// A file with groups, patterns and two tabs, in the form in which KLayout 0.30 saves it.
const SAVED: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<layer-properties-tabs>
 <layer-properties>
  <properties>
   <expanded>true</expanded>
   <frame-color>#ff0000</frame-color>
   <fill-color>#80808080</fill-color>
   <frame-brightness>16</frame-brightness>
   <fill-brightness>-128</fill-brightness>
   <dither-pattern>C1</dither-pattern>
   <line-style>I3</line-style>
   <valid>true</valid>
   <visible>false</visible>
   <transparent>true</transparent>
   <width>3</width>
   <marked>true</marked>
   <xfill>true</xfill>
   <animation>2</animation>
   <name>metals &amp; &lt;more&gt;</name>
   <source>*/*@*</source>
   <group-members>
    <expanded>false</expanded>
    <frame-color/>
    <fill-color/>
    <name>M1 - (first)</name>
    <source>31/0@1</source>
   </group-members>
   <group-members>
    <name>via</name>
    <source>via (32/5)@1 (r90) #0..2</source>
   </group-members>
  </properties>
  <custom-dither-pattern>
   <pattern><line>*.</line><line>.*</line></pattern>
   <order>1</order>
   <name>check</name>
  </custom-dither-pattern>
  <custom-dither-pattern/>
  <custom-line-style><pattern>***..</pattern><order>2</order><name>dash</name></custom-line-style>
  <name>all</name>
 </layer-properties>
 <layer-properties>
  <properties><source>by-name@1</source><later>1</later></properties>
  <name/>
 </layer-properties>
</layer-properties-tabs>
"#;

#[test]
fn a_file_of_klayout_is_read_whole_and_written_the_same() {
    let read = lyp::from_str(SAVED).unwrap();
    let [all, second] = &read.tabs[..] else { panic!("two tabs") };
    let [group] = &all.layers[..] else { panic!("one group") };
    assert_eq!((all.name.as_str(), group.name.as_str()), ("all", "metals & <more>"));
    assert_eq!(group.fill_color.unwrap().to_string(), "#808080");
    assert_eq!((group.pattern, group.line_style), (Some(Pattern::Custom(1)), Some(LineStyle::BuiltIn(3))));
    assert_eq!((group.width, group.animation, group.frame_brightness), (Some(3), 2, 16));
    assert!(group.expanded && !group.visible && group.transparent && group.marked && group.xfill);
    assert_eq!(group.members[1].source, Source("via (32/5)@1 (r90) #0..2".to_owned()));
    let check = CustomPattern { rows: vec!["*.".to_owned(), ".*".to_owned()], order: 1, name: "check".to_owned() };
    assert_eq!(all.patterns, [check, CustomPattern::default()]);
    assert_eq!(all.lines, [CustomLine { pattern: "***..".to_owned(), order: 2, name: "dash".to_owned() }]);
    assert_eq!(second.layers[0].source.0, "by-name@1");
    assert_eq!(read.unknown.iter().map(|e| (e.line, e.name.as_str())).collect::<Vec<_>>(), [(43, "later")]);
    let again = lyp::from_str(&lyp::to_string(&read)).unwrap();
    assert_eq!(again.tabs, read.tabs);
}

#[test]
fn leaves_with_numbers_become_layers_and_the_others_are_listed() {
    let layers = lyp::from_str(SAVED).unwrap().to_layers();
    let found: Vec<(&str, Layer, &str)> =
        layers.set.iter().map(|named| (named.name.as_str(), named.layer, named.description.as_str())).collect();
    assert_eq!(found, [("M1", Layer::new(31, 0), "first"), ("via", Layer::new(32, 5), "")]);
    // Half as bright as #808080, the color of the group.
    assert_eq!(layers.set.get("M1").unwrap().color.unwrap().to_string(), "#404040");
    let [problem] = &layers.problems[..] else { panic!("one problem") };
    assert_eq!(
        problem.to_string(),
        "layer \"\" with the source \"by-name@1\" is left out: its source has a name without numbers"
    );
}

fn set() -> LayerSet {
    let mut set = LayerSet::new();
    let layers = [
        NamedLayer { dither: Some("I3".to_owned()), ..NamedLayer::new("au", (4, 1)).color("#daa520".parse().unwrap()) },
        NamedLayer { alpha: 1.0, ..NamedLayer::new("a<b> & 'c' \"d\"", 2).description("x - (y)") },
        NamedLayer::new("one - two", 9),
    ];
    for layer in layers {
        set.add(layer).unwrap();
    }
    set
}

#[test]
fn a_layer_set_comes_back_in_the_order_of_its_layers() {
    for names in [LypNames::Plain, LypNames::Phidl] {
        let lyp = Lyp::from_layers(&set(), names).unwrap();
        let back = lyp::from_str(&lyp::to_string(&lyp)).unwrap();
        assert_eq!(back, lyp);
        let layers = back.to_layers();
        assert_eq!(layers.problems, []);
        let mut expected: Vec<NamedLayer> = set().iter().cloned().collect();
        expected.sort_by_key(|named| named.layer);
        let found: Vec<&NamedLayer> = layers.set.iter().collect();
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.into_iter().zip(&expected) {
            let key = |named: &NamedLayer| (named.name.clone(), named.layer, named.description.clone());
            assert_eq!(key(found), key(expected));
        }
        let brightness = if names == LypNames::Phidl { -25 } else { 0 };
        assert_eq!(lyp.tabs[0].layers[0].fill_brightness, brightness);
    }
    let ordinary = Lyp::from_layers(&set(), LypNames::Plain).unwrap();
    let views = &ordinary.tabs[0].layers;
    // Patterns of PHIDL's cycle, which a layer with its own does not advance.
    let patterns: Vec<Option<Pattern>> = views.iter().map(|view| view.pattern).collect();
    assert_eq!(patterns, [2, 3, 5].map(|number| Some(Pattern::BuiltIn(number))));
    assert_eq!(views.iter().map(|view| view.transparent).collect::<Vec<_>>(), [false, true, true]);
}

/// `write_lyp` of PHIDL 1.7 writes this name.
#[test]
fn names_of_phidl_have_the_numbers_in_front() {
    let phidl = Lyp::from_layers(&set(), LypNames::Phidl).unwrap();
    assert_eq!(phidl.tabs[0].layers[1].name, "4/1 - au");
    let mut set = LayerSet::new();
    set.add(NamedLayer::new("au", 4).description("Gold wiring")).unwrap();
    let phidl = Lyp::from_layers(&set, LypNames::Phidl).unwrap();
    assert_eq!(phidl.tabs[0].layers[0].name, "4/0 - au - (Gold wiring)");
}

#[test]
fn names_that_repeat_get_their_numbers() {
    let layer =
        |source: &str| LayerView { name: "m".to_owned(), source: Source(source.to_owned()), ..Default::default() };
    let view = View { layers: vec![layer("1/0"), layer("2/0"), layer("2/0")], ..View::default() };
    let layers = Lyp { tabs: vec![view], unknown: Vec::new() }.to_layers();
    assert_eq!(layers.set.iter().map(|named| named.name.as_str()).collect::<Vec<_>>(), ["m", "m (2/0)"]);
    assert_eq!(layers.problems.len(), 1);
}

#[test]
fn files_that_are_none_say_where_and_why() {
    let refused = |text: &str| lyp::from_str(text).unwrap_err().to_string();
    assert_eq!(
        refused("<a>\n</a>"),
        "this text, line 1, column 1: the root element is <a>, but it must be <layer-properties>"
    );
    assert_eq!(
        refused("<layer-properties>\n <properties>\n  <animation>9</animation></properties></layer-properties>"),
        "this text, line 3, column 3: <animation> is \"9\", which the format does not have"
    );
    let nested = "<properties>".repeat(1_000_000);
    assert!(refused(&format!("<layer-properties>{nested}")).contains("nested deeper than 64 levels"));
    let dtd = "<!DOCTYPE a [<!ENTITY b \"c\">]><layer-properties/>";
    assert!(matches!(lyp::from_str(dtd), Err(IoError::Xml { .. })));
    for text in ["", "<layer-properties>", "<layer-properties></a>", "\u{0}", "<<<<"] {
        assert!(lyp::from_str(text).is_err(), "{text:?}");
    }
}

#[test]
fn groups_may_be_nested_and_deeper_ones_are_refused() {
    let groups = |levels: usize| {
        let mut view = LayerView { source: Source("1/0".to_owned()), ..LayerView::default() };
        for _ in 1..levels {
            view = LayerView { members: vec![view], ..LayerView::default() };
        }
        lyp::to_string(&Lyp { tabs: vec![View { layers: vec![view], ..View::default() }], unknown: Vec::new() })
    };
    assert_eq!(lyp::from_str(&groups(64)).unwrap().to_layers().set.iter().len(), 1);
    assert!(lyp::from_str(&groups(65)).unwrap_err().to_string().contains("64 levels"));
}

#[test]
fn a_pattern_that_a_set_cannot_have_is_refused() {
    for dither in ["C1", "5", "I47", "solid"] {
        let mut set = LayerSet::new();
        set.add(NamedLayer { dither: Some(dither.to_owned()), ..NamedLayer::new("m", 1) }).unwrap();
        let error = Lyp::from_layers(&set, LypNames::Plain).unwrap_err().to_string();
        assert!(error.contains(dither) && error.contains("I0 to I46"), "{error}");
    }
}
