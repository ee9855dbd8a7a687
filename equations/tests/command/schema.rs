//! Answers in JSON are made of what their schemas say, and of nothing else.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::Value;

use super::{answer, folder};

/// A folder of its own for each answer.
fn fresh() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    folder(&format!("schema_{}", COUNT.fetch_add(1, Ordering::Relaxed)))
}

/// A schema as `assur schema` prints it, so far as those use the language of JSON Schema.
struct Schema(Value);

impl Schema {
    fn of(command: &str) -> Self {
        let text = answer(&["schema", command], &fresh());
        Self(serde_json::from_str(&text).expect("JSON"))
    }

    /// What a reference leads to.
    fn resolved<'a>(&'a self, schema: &'a Value) -> Option<&'a Value> {
        let path = schema["$ref"].as_str()?.strip_prefix('#')?;
        Some(self.0.pointer(path).expect("a definition"))
    }

    /// The alternatives of a schema, one of which has to hold.
    fn alternatives(schema: &Value) -> Option<&Vec<Value>> {
        schema["anyOf"].as_array().or(schema["oneOf"].as_array())
    }

    /// Names of fields that a schema knows.
    fn fields(&self, schema: &Value) -> Vec<String> {
        let own = schema["properties"].as_object().into_iter().flatten();
        let mut list: Vec<String> = own.map(|(name, _)| name.clone()).collect();
        list.extend(self.resolved(schema).into_iter().flat_map(|other| self.fields(other)));
        let alternatives = Self::alternatives(schema).into_iter().flatten();
        list.extend(alternatives.flat_map(|other| self.fields(other)));
        list
    }

    /// Why a value is not as a schema says; nothing if it is.
    fn fault(&self, schema: &Value, value: &Value, place: &str) -> Option<String> {
        let kinds = match &schema["type"] {
            Value::Array(kinds) => kinds.iter().collect(),
            Value::Null => Vec::new(),
            kind => vec![kind],
        };
        let is = |kind: &&Value| match kind.as_str() {
            Some("object") => value.is_object(),
            Some("array") => value.is_array(),
            Some("string") => value.is_string(),
            Some("number") => value.is_number(),
            Some("integer") => value.is_u64() || value.is_i64(),
            Some("boolean") => value.is_boolean(),
            Some("null") => value.is_null(),
            _ => panic!("an unknown type: {schema}"),
        };
        if !(kinds.is_empty() || kinds.iter().any(is)) {
            return Some(format!("{place} is {value}, no {}", schema["type"]));
        }
        let known = schema["enum"].as_array();
        let constant = schema.get("const");
        if known.is_some_and(|known| !known.contains(value))
            || constant.is_some_and(|one| one != value)
        {
            return Some(format!("{place} is {value}"));
        }
        let required = schema["required"].as_array().into_iter().flatten();
        let mut required = required.filter_map(Value::as_str);
        if let Some(lacks) = required.find(|name| value.get(name).is_none()) {
            return Some(format!("{place} lacks {lacks}"));
        }
        let fields = schema["properties"].as_object().into_iter().flatten();
        let fields = fields.filter_map(|(name, schema)| {
            self.fault(schema, value.get(name)?, &format!("{place}.{name}"))
        });
        let items = value.as_array().filter(|_| schema.get("items").is_some());
        let items = items.into_iter().flatten().enumerate().filter_map(|(index, item)| {
            self.fault(&schema["items"], item, &format!("{place}[{index}]"))
        });
        let other = self.resolved(schema).and_then(|other| self.fault(other, value, place));
        let several = Self::alternatives(schema).and_then(|all| {
            let mut faults = all.iter().map(|one| self.fault(one, value, place));
            let found: Vec<String> = faults.by_ref().map_while(|fault| fault).collect();
            (found.len() == all.len()).then(|| found.join(", or "))
        });
        fields.chain(items).chain(other).chain(several).next()
    }

    /// A field that no schema knows, where all of them are listed.
    fn stranger(&self, schema: &Value, value: &Value, place: &str) -> Option<String> {
        let fields = self.fields(schema);
        if let Some(object) = value.as_object().filter(|_| !fields.is_empty()) {
            let mut names = object.keys();
            if let Some(unknown) = names.find(|name| !fields.contains(name)) {
                return Some(format!("{place}.{unknown} is not in the schema"));
            }
        }
        let below = schema["properties"].as_object().into_iter().flatten();
        let below = below.filter_map(|(name, schema)| {
            self.stranger(schema, value.get(name)?, &format!("{place}.{name}"))
        });
        let items = value.as_array().into_iter().flatten();
        let items = items.filter_map(|item| self.stranger(&schema["items"], item, place));
        let other = self.resolved(schema).filter(|_| fields.is_empty() || value.is_array());
        let other = other.and_then(|other| self.stranger(other, value, place));
        below.chain(items).chain(other).next()
    }
}

#[track_caller]
fn check(schema: &Schema, arguments: &[&str]) {
    let text = answer(&[arguments, &["--format", "json"]].concat(), &fresh());
    let object: Value = serde_json::from_str(&text).expect("JSON");
    let fault = schema.fault(&schema.0, &object, "");
    assert_eq!(fault, None, "{arguments:?}");
    assert_eq!(schema.stranger(&schema.0, &object, ""), None, "{arguments:?}");
}

#[test]
fn motions_and_linkages_are_as_the_schema_says() {
    let schema = Schema::of("run");
    check(&schema, &["run", "batten", "--at", "theta=110deg", "--atol", "phi2=1e-9 rad"]);
    check(&schema, &["run", "table_drive", "--method", "auto", "--at", "time=1ms"]);
    check(&schema, &["run", "presser_foot"]);
    check(&schema, &["run", "heald_linkage", "--at", "phi4=90deg"]);
    check(&schema, &["run", "selvedge_linkage", "--scene", "turning"]);
}

#[test]
fn other_answers_are_as_their_schemas_say() {
    let [heald, foot] = ["heald_linkage", "presser_foot"];
    check(&Schema::of("structure"), &["structure", heald]);
    check(&Schema::of("modes"), &["modes", heald, "--at", "phi4=200deg"]);
    let chosen = ["--allocate", "1mrad", "--samples", "100", "--play", "l5=0.02mm"];
    let tolerance = Schema::of("tolerance");
    check(&tolerance, &[&["tolerance", heald, "--output", "phi7"][..], &chosen].concat());
    let study = Schema::of("study");
    check(&study, &["study", foot, "--over", "omega=200..300[1/s]:2"]);
    let cost = ["cost", foot, "--rtol", "1e-6..1e-5", "--seconds", "0"];
    check(&Schema::of("cost"), &cost);
    let over = ["study", "batten", "--resonances", "--over", "n=248..249rpm:3"];
    check(&Schema::of("resonances"), &over);
    check(&study, &["study", foot, "--samples", "4", "--tolerance", "omega=1%"]);
}

#[test]
fn what_a_schema_does_not_say_is_found() {
    let schema = Schema::of("modes");
    let text = answer(&["modes", "heald_linkage", "--format", "json"], &fresh());
    let object: Value = serde_json::from_str(&text).expect("JSON");
    let changed = |path: &str, value: Value| {
        let mut object = object.clone();
        *object.pointer_mut(path).expect("a field") = value;
        schema.fault(&schema.0, &object, "")
    };
    assert!(changed("/status", "perhaps".into()).is_some());
    assert!(changed("/places/0/complete", 1.into()).is_some());
    assert!(changed("/parameters/0", Value::Object(Default::default())).is_some());
    let mut more = object.clone();
    more["places"][0]["other"] = 1.into();
    assert!(schema.stranger(&schema.0, &more, "").is_some());
}
